// Where the pointer means to be in the plan: on a point, where a line touches a rod, in the middle of a rod, on a rod, on the line of symmetry, in
// steps of 15 degrees from the point before, near the lines of the grid. The first that is within reach wins.

import { nearestOnLine } from './picking';
import type { PlanEvent, Symmetry, Vec2 } from './protocol';
import { distance2 } from './vec';

export interface SnapOptions {
  grid: boolean;
  points: boolean;
  rods: boolean;
  angle: boolean;
  symmetry: boolean;
}

export interface SnapRequest {
  at: Vec2;
  options: SnapOptions;
  grid_mm: number;
  /** mm that count as near. */
  reach_mm: number;
  /** The point before, for angles. */
  from?: Vec2 | null;
  /** Points that move with the pointer, and rods through them, do not hold it. */
  except?: ReadonlySet<string>;
  /** Alt is held: no snapping. */
  suspended?: boolean;
}

export interface Snap {
  at: Vec2;
  kind: 'free' | 'point' | 'tangent' | 'middle' | 'rod' | 'symmetry' | 'angle' | 'grid';
  /** Name of the point or rod. */
  name: string;
  /** What to draw: a line that explains the place. */
  guide: [Vec2, Vec2] | null;
}

export const kAngleStep = 15;

export function snap(request: SnapRequest, plan: PlanEvent | null): Snap {
  const free: Snap = { at: request.at, kind: 'free', name: '', guide: null };
  if (request.suspended || !plan) return free;
  const { options } = request;
  return (
    (options.points && toPoint(request, plan)) ||
    (options.rods && (toTangent(request, plan) || toRod(request, plan))) ||
    (options.symmetry && toSymmetry(request, plan.constraints.symmetric)) ||
    (options.angle && toAngle(request)) ||
    (options.grid && toGrid(request)) ||
    free
  );
}

function toPoint({ at, reach_mm, except }: SnapRequest, plan: PlanEvent): Snap | null {
  let best: Snap | null = null;
  let nearest = reach_mm;
  for (const point of plan.points) {
    const distance = distance2(at, point.at_mm);
    if (distance > nearest || except?.has(point.name)) continue;
    nearest = distance;
    best = { at: point.at_mm, kind: 'point', name: point.name, guide: null };
  }
  return best;
}

function toRod({ at, reach_mm, except }: SnapRequest, plan: PlanEvent): Snap | null {
  let best: Snap | null = null;
  let nearest = reach_mm;
  for (const rod of plan.rods) {
    if (except && rod.points.some((i) => except.has(plan.points[i].name))) continue;
    const middle = middleOf(rod.line_mm);
    if (middle && distance2(at, middle) <= reach_mm) return { at: middle, kind: 'middle', name: rod.name, guide: null };
    const found = nearestOnLine(at, rod.line_mm);
    if (found.distance > nearest) continue;
    nearest = found.distance;
    best = { at: found.at, kind: 'rod', name: rod.name, guide: null };
  }
  return best;
}

/** Where the line from the point before touches a rod without crossing it. */
function toTangent({ at, from, reach_mm, except }: SnapRequest, plan: PlanEvent): Snap | null {
  if (!from) return null;
  let best: Snap | null = null;
  let nearest = reach_mm;
  for (const rod of plan.rods) {
    if (except && rod.points.some((i) => except.has(plan.points[i].name))) continue;
    const line = rod.line_mm;
    // From which side the line from `from` to a place of the rod meets it: it changes where both have one direction.
    const side = (i: number) => (line[i + 1][0] - line[i][0]) * (line[i][1] - from[1]) - (line[i + 1][1] - line[i][1]) * (line[i][0] - from[0]);
    for (let i = 1; i + 1 < line.length; ++i) {
      const distance = distance2(at, line[i]);
      if (distance > nearest || distance2(line[i], from) < 2 * reach_mm || side(i - 1) * side(i) >= 0) continue;
      nearest = distance;
      best = { at: line[i], kind: 'tangent', name: rod.name, guide: [from, line[i]] };
    }
  }
  return best;
}

/** The place half way along a line. */
export function middleOf(line: readonly Vec2[]): Vec2 | null {
  const lengths = line.slice(1).map((b, i) => distance2(line[i], b));
  let left = lengths.reduce((sum, l) => sum + l, 0) / 2;
  for (let i = 0; i < lengths.length; ++i) {
    if (left <= lengths[i] && lengths[i] > 0) {
      const t = left / lengths[i];
      return [line[i][0] + t * (line[i + 1][0] - line[i][0]), line[i][1] + t * (line[i + 1][1] - line[i][1])];
    }
    left -= lengths[i];
  }
  return null;
}

const kFar = 1e4;

function toSymmetry({ at, reach_mm }: SnapRequest, symmetric: Symmetry | null): Snap | null {
  if (!symmetric) return null;
  const k = symmetric.axis === 'x' ? 0 : 1;
  if (Math.abs(at[k] - symmetric.at_mm) > reach_mm) return null;
  const on: Vec2 = k === 0 ? [symmetric.at_mm, at[1]] : [at[0], symmetric.at_mm];
  const guide: [Vec2, Vec2] = k === 0 ? [[on[0], -kFar], [on[0], kFar]] : [[-kFar, on[1]], [kFar, on[1]]];
  return { at: on, kind: 'symmetry', name: symmetric.axis, guide };
}

function toAngle({ at, from, reach_mm }: SnapRequest): Snap | null {
  if (!from) return null;
  const length = distance2(at, from);
  if (length < 2 * reach_mm) return null;
  const step = (kAngleStep * Math.PI) / 180;
  const angle = Math.round(Math.atan2(at[1] - from[1], at[0] - from[0]) / step) * step;
  const along: Vec2 = [Math.cos(angle), Math.sin(angle)];
  const reach = (at[0] - from[0]) * along[0] + (at[1] - from[1]) * along[1];
  const on: Vec2 = [from[0] + reach * along[0], from[1] + reach * along[1]];
  if (distance2(on, at) > 0.7 * reach_mm) return null;
  const guide: [Vec2, Vec2] = [from, [from[0] + kFar * along[0], from[1] + kFar * along[1]]];
  return { at: on, kind: 'angle', name: `${Math.round((angle * 180) / Math.PI)}°`, guide };
}

/** Each coordinate by itself, when a line of the grid is near. */
function toGrid({ at, grid_mm, reach_mm }: SnapRequest): Snap | null {
  const near = (x: number) => {
    const line = Math.round(x / grid_mm) * grid_mm;
    return Math.abs(line - x) <= Math.min(0.6 * reach_mm, 0.3 * grid_mm) ? line : x;
  };
  const on: Vec2 = [near(at[0]), near(at[1])];
  if (on[0] === at[0] && on[1] === at[1]) return null;
  return { at: on, kind: 'grid', name: '', guide: null };
}
