// Rods as they will look once the engine has followed the pointer: their lines, bent by how far their points are from
// where the plan still has them. Good for the 50 ms until the true line comes.

import type { PlanEvent, PlanRod, Vec2 } from './protocol';
import { distance2 } from './vec';

export type Moves = ReadonlyMap<string, Vec2>;

/** Where a point is drawn. */
export function placeOf(plan: PlanEvent, index: number, moves: Moves): Vec2 {
  const point = plan.points[index];
  return moves.get(point.name) ?? point.at_mm;
}

/** The line of a rod as it is drawn. */
export function lineOf(plan: PlanEvent, rod: PlanRod, moves: Moves): readonly Vec2[] {
  if (moves.size === 0 || !rod.points.some((i) => moves.has(plan.points[i].name))) return rod.line_mm;
  const line = rod.line_mm;
  const knots = knotsOf(plan, rod);
  const offset = rod.points.map((i): Vec2 => {
    const { name, at_mm } = plan.points[i];
    const to = moves.get(name) ?? at_mm;
    return [to[0] - at_mm[0], to[1] - at_mm[1]];
  });
  const last = line.length - 1;
  if (rod.closed) {
    knots.push(last);
    offset.push(offset[0]);
  }
  let k = 0;
  return line.map((p, i): Vec2 => {
    while (k + 2 < knots.length && i > knots[k + 1]) ++k;
    const from = knots[k];
    const to = knots[k + 1] ?? last;
    const t = to > from ? Math.min(Math.max((i - from) / (to - from), 0), 1) : 0;
    // Smooth at the knots, as splines are; straight rods stay straight.
    const s = rod.curve === 'straight' ? t : t * t * (3 - 2 * t);
    const a = offset[k];
    const b = offset[k + 1] ?? a;
    return [p[0] + a[0] + s * (b[0] - a[0]), p[1] + a[1] + s * (b[1] - a[1])];
  });
}

/** Of each point of a rod the nearest sample of its line, in order along it. */
function knotsOf(plan: PlanEvent, rod: PlanRod): number[] {
  let from = 0;
  return rod.points.map((index) => {
    const { at_mm } = plan.points[index];
    let best = from;
    let nearest = Infinity;
    for (let i = from; i < rod.line_mm.length; ++i) {
      const distance = distance2(rod.line_mm[i], at_mm);
      if (distance < nearest) {
        nearest = distance;
        best = i;
      }
    }
    from = best;
    return best;
  });
}
