// Colours of the 3D view and the plan in both themes, sRGB.

import type { Colour } from '../core/colours';

export interface Palette {
  ground: Colour;
  grid: Colour;
  fabric: Colour;
  /** Fabric seen from below, so that folds read. */
  fabricBack: Colour;
  rod: Colour;
  ghost: Colour;
  select: Colour;
  hover: Colour;
  pin: Colour;
  link: Colour;
  preview: Colour;
  previous: Colour;
  flat: Colour;
  mode: Colour;
  warn: Colour;
  ink: Colour;
  inkSoft: Colour;
  axes: [Colour, Colour, Colour];
}

export const lightPalette: Palette = {
  ground: [251, 250, 247],
  grid: [176, 170, 158],
  fabric: [240, 230, 214],
  fabricBack: [222, 209, 190],
  rod: [46, 49, 56],
  ghost: [120, 116, 108],
  select: [232, 101, 10],
  hover: [247, 168, 106],
  pin: [31, 95, 191],
  link: [31, 95, 191],
  preview: [232, 101, 10],
  previous: [96, 110, 130],
  flat: [110, 120, 130],
  mode: [31, 95, 191],
  warn: [168, 35, 27],
  ink: [31, 33, 38],
  inkSoft: [88, 90, 97],
  axes: [
    [200, 58, 52],
    [60, 134, 58],
    [40, 98, 196],
  ],
};

export const darkPalette: Palette = {
  ground: [23, 24, 27],
  grid: [96, 100, 110],
  fabric: [166, 158, 146],
  fabricBack: [118, 112, 104],
  rod: [226, 226, 222],
  ghost: [140, 143, 150],
  select: [255, 138, 61],
  hover: [255, 190, 140],
  pin: [127, 178, 255],
  link: [127, 178, 255],
  preview: [255, 138, 61],
  previous: [150, 164, 186],
  flat: [150, 160, 172],
  mode: [127, 178, 255],
  warn: [255, 154, 143],
  ink: [236, 235, 231],
  inkSoft: [169, 172, 179],
  axes: [
    [240, 106, 98],
    [118, 196, 112],
    [112, 164, 255],
  ],
};

export function paletteOf(dark: boolean): Palette {
  return dark ? darkPalette : lightPalette;
}
