// Colours of values. Diverging: blue for compression, white, red for tension, readable by people who are colour-blind.
// Sequential: even steps of lightness, from dark violet over teal to pale yellow.

export type Colour = [number, number, number];

/** Anchors at equal distances, sRGB of 0 to 255. */
const kDiverging: Colour[] = [
  [22, 66, 124],
  [47, 109, 181],
  [118, 168, 214],
  [189, 212, 232],
  [243, 242, 239],
  [240, 203, 188],
  [224, 141, 118],
  [194, 59, 59],
  [128, 18, 36],
];
const kSequential: Colour[] = [
  [58, 30, 92],
  [66, 62, 133],
  [55, 95, 146],
  [42, 125, 149],
  [38, 154, 145],
  [74, 183, 130],
  [135, 208, 105],
  [202, 226, 92],
  [250, 240, 140],
];

/** Colour at t in [0, 1]. */
export function colourAt(diverging: boolean, t: number): Colour {
  const anchors = diverging ? kDiverging : kSequential;
  const place = Math.min(Math.max(t, 0), 1) * (anchors.length - 1);
  const i = Math.min(Math.floor(place), anchors.length - 2);
  const f = place - i;
  return [0, 1, 2].map((k) => Math.round(anchors[i][k] + f * (anchors[i + 1][k] - anchors[i][k]))) as Colour;
}

/** Colour of a value within a range. */
export function colourOf(value: number, low: number, high: number, diverging: boolean): Colour {
  return colourAt(diverging, high > low ? (value - low) / (high - low) : 0.5);
}

/** "rgb(1 2 3)". */
export function css(colour: Colour): string {
  return `rgb(${colour[0]} ${colour[1]} ${colour[2]})`;
}

/** RGBA bytes of a table with `size` steps, for a lookup texture. */
export function colourTable(diverging: boolean, size: number): Uint8Array {
  const out = new Uint8Array(4 * size);
  for (let i = 0; i < size; ++i) {
    out.set(colourAt(diverging, i / (size - 1)), 4 * i);
    out[4 * i + 3] = 255;
  }
  return out;
}
