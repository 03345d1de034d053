// Lengths that people like on scales and rulers.

/** The largest of 1, 2, 5 times a power of ten that is not above `most`. */
export function niceLength(most: number): number {
  const power = Math.pow(10, Math.floor(Math.log10(most)));
  for (const step of [5, 2]) if (step * power <= most) return rounded(step * power);
  return rounded(power);
}

/** The smallest of 1, 2, 5 times a power of ten that is not below `least`. */
export function niceStep(least: number): number {
  const power = Math.pow(10, Math.floor(Math.log10(least) + 1e-9));
  for (const step of [1, 2, 5]) if (step * power >= least * (1 - 1e-9)) return rounded(step * power);
  return rounded(10 * power);
}

function rounded(x: number): number {
  return Number(x.toPrecision(6));
}

/** Marks of a ruler between two values: every `step`, with a label at each `labelled`-th. */
export function marks(from: number, to: number, step: number, labelled = 5): { at: number; label: string }[] {
  const out: { at: number; label: string }[] = [];
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; ++i) {
    out.push({ at: rounded(i * step), label: i % labelled === 0 ? String(rounded(i * step)).replace('-', '−') : '' });
  }
  return out;
}
