// Editing with a mirror: what is done on one side is done on the other.

import type { PlanEvent, Symmetry, Vec2 } from './protocol';
import { distance2 } from './vec';

/** How far apart mirror images may be and still count, mm. */
const kTolerance = 0.05;

export function mirrored(at: Vec2, symmetric: Symmetry): Vec2 {
  return symmetric.axis === 'x' ? [2 * symmetric.at_mm - at[0], at[1]] : [at[0], 2 * symmetric.at_mm - at[1]];
}

/** Moves with those of mirror images added; points on the line stay on it. */
export function withImages(plan: PlanEvent, moves: { point: string; to_mm: Vec2 }[]): { point: string; to_mm: Vec2 }[] {
  const { symmetric } = plan.constraints;
  if (!symmetric) return moves;
  const own = new Set(moves.map((m) => m.point));
  const out: { point: string; to_mm: Vec2 }[] = [];
  for (const move of moves) {
    const at = plan.points.find((p) => p.name === move.point)?.at_mm;
    if (!at) continue;
    const image = mirrored(at, symmetric);
    if (distance2(at, image) < kTolerance) {
      const k = symmetric.axis === 'x' ? 0 : 1;
      const to: Vec2 = [...move.to_mm];
      to[k] = symmetric.at_mm;
      out.push({ point: move.point, to_mm: to });
      continue;
    }
    out.push(move);
    const partner = plan.points.find((p) => p.name !== move.point && distance2(p.at_mm, image) < kTolerance);
    if (partner && !own.has(partner.name)) out.push({ point: partner.name, to_mm: mirrored(move.to_mm, symmetric) });
  }
  return out;
}
