// Selecting by box and lasso. A box drawn from left to right takes what lies inside, from right to left what it touches
// (the habit of CAD programs); a lasso takes what lies inside.

import type { Vec2 } from './vec';

export interface Box {
  low: Vec2;
  high: Vec2;
  touching: boolean;
}

export function boxOf(from: Vec2, to: Vec2): Box {
  return {
    low: [Math.min(from[0], to[0]), Math.min(from[1], to[1])],
    high: [Math.max(from[0], to[0]), Math.max(from[1], to[1])],
    touching: to[0] < from[0],
  };
}

export function inBox(box: Box, p: Vec2): boolean {
  return p[0] >= box.low[0] && p[0] <= box.high[0] && p[1] >= box.low[1] && p[1] <= box.high[1];
}

/** Whether a segment has a point in the box (Liang and Barsky's clipping). */
export function segmentTouches(box: Box, a: Vec2, b: Vec2): boolean {
  let from = 0;
  let to = 1;
  for (let k = 0; k < 2; ++k) {
    const d = b[k] - a[k];
    const low = box.low[k] - a[k];
    const high = box.high[k] - a[k];
    if (d === 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    from = Math.max(from, Math.min(low / d, high / d));
    to = Math.min(to, Math.max(low / d, high / d));
    if (from > to) return false;
  }
  return true;
}

/** Whether a line is taken by the box. */
export function lineInBox(box: Box, line: readonly Vec2[]): boolean {
  if (line.length === 0) return false;
  if (!box.touching) return line.every((p) => inBox(box, p));
  if (line.length === 1) return inBox(box, line[0]);
  return line.some((p, i) => i > 0 && segmentTouches(box, line[i - 1], p));
}

/** Whether a point lies inside a closed polygon (even-odd). */
export function inPolygon(polygon: readonly Vec2[], p: Vec2): boolean {
  let inside = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const a = polygon[i];
    const b = polygon[j];
    if (a[1] > p[1] !== b[1] > p[1] && p[0] < ((b[0] - a[0]) * (p[1] - a[1])) / (b[1] - a[1]) + a[0]) inside = !inside;
  }
  return inside;
}

/** What takes points and lines: a box or a lasso. */
export interface Region {
  point(p: Vec2): boolean;
  line(line: readonly Vec2[]): boolean;
}

export function boxRegion(from: Vec2, to: Vec2): Region {
  const box = boxOf(from, to);
  return { point: (p) => inBox(box, p), line: (line) => lineInBox(box, line) };
}

export function lassoRegion(polygon: readonly Vec2[]): Region {
  return {
    point: (p) => inPolygon(polygon, p),
    line: (line) => line.length > 0 && line.every((p) => inPolygon(polygon, p)),
  };
}
