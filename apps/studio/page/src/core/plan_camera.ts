// What the plan shows: a place in the middle and pixels per mm; y runs up in the plan and down on the screen.

import type { Screen } from './camera';
import type { Vec2 } from './protocol';
import { clamp } from './vec';

export interface PlanCamera {
  center_mm: Vec2;
  pixels_per_mm: number;
}

export function toPixel(camera: PlanCamera, screen: Screen, at: Vec2): Vec2 {
  return [
    screen.width / 2 + (at[0] - camera.center_mm[0]) * camera.pixels_per_mm,
    screen.height / 2 - (at[1] - camera.center_mm[1]) * camera.pixels_per_mm,
  ];
}

export function toPlan(camera: PlanCamera, screen: Screen, pixel: Vec2): Vec2 {
  return [
    camera.center_mm[0] + (pixel[0] - screen.width / 2) / camera.pixels_per_mm,
    camera.center_mm[1] - (pixel[1] - screen.height / 2) / camera.pixels_per_mm,
  ];
}

export function panPlan(camera: PlanCamera, dx: number, dy: number): PlanCamera {
  const { center_mm: c, pixels_per_mm: s } = camera;
  return { center_mm: [c[0] - dx / s, c[1] + dy / s], pixels_per_mm: s };
}

/** Zooms (above 1: nearer); what is under the pointer stays there. */
export function zoomPlan(camera: PlanCamera, screen: Screen, pixel: Vec2, factor: number): PlanCamera {
  const held = toPlan(camera, screen, pixel);
  const next = { ...camera, pixels_per_mm: clamp(camera.pixels_per_mm * factor, 0.02, 400) };
  const now = toPlan(next, screen, pixel);
  const { center_mm: c } = camera;
  return { ...next, center_mm: [c[0] + held[0] - now[0], c[1] + held[1] - now[1]] };
}

/** Shows all of some places. `inset`: pixels that rulers take at the left and top. */
export function fitPlan(places: readonly Vec2[], screen: Screen, inset: number): PlanCamera | null {
  if (places.length === 0 || screen.width < 2 || screen.height < 2) return null;
  const xs = places.map((p) => p[0]);
  const ys = places.map((p) => p[1]);
  const low: Vec2 = [Math.min(...xs), Math.min(...ys)];
  const high: Vec2 = [Math.max(...xs), Math.max(...ys)];
  const width = Math.max(high[0] - low[0], 1);
  const height = Math.max(high[1] - low[1], 1);
  const margin = 18;
  const free: Vec2 = [Math.max(screen.width - inset - 2 * margin, 20), Math.max(screen.height - inset - 2 * margin, 20)];
  const scale = clamp(Math.min(free[0] / width, free[1] / height), 0.02, 400);
  return {
    center_mm: [(low[0] + high[0]) / 2 - inset / 2 / scale, (low[1] + high[1]) / 2 + inset / 2 / scale],
    pixels_per_mm: scale,
  };
}
