// What lies under the pointer in the plan, and what a box or lasso takes.

import { lineOf, placeOf, type Moves } from './echo';
import { nearestOnLine } from './picking';
import type { PlanEvent, Vec2 } from './protocol';
import type { Region } from './regions';
import { makeSelection, type Selection } from './selection';
import { distance2 } from './vec';

export interface PlanHit {
  kind: 'point' | 'rod';
  name: string;
  index: number;
  /** mm: the point itself, or the nearest place on the rod. */
  at: Vec2;
}

export interface PlanFilter {
  points: boolean;
  rods: boolean;
}

/** Points come before rods. Reaches are mm. */
export function pickPlan(plan: PlanEvent, at: Vec2, pointReach: number, rodReach: number, filter: PlanFilter, moves: Moves): PlanHit | null {
  return (filter.points ? pickPoint(plan, at, pointReach, moves) : null) ?? (filter.rods ? pickRod(plan, at, rodReach, moves) : null);
}

function pickPoint(plan: PlanEvent, at: Vec2, reach: number, moves: Moves): PlanHit | null {
  let best: PlanHit | null = null;
  let nearest = reach;
  plan.points.forEach(({ name }, index) => {
    const place = placeOf(plan, index, moves);
    const distance = distance2(at, place);
    if (distance > nearest) return;
    nearest = distance;
    best = { kind: 'point', name, index, at: place };
  });
  return best;
}

function pickRod(plan: PlanEvent, at: Vec2, reach: number, moves: Moves): PlanHit | null {
  let best: PlanHit | null = null;
  let nearest = reach;
  plan.rods.forEach((rod, index) => {
    const found = nearestOnLine(at, lineOf(plan, rod, moves));
    if (found.distance > nearest) return;
    nearest = found.distance;
    best = { kind: 'rod', name: rod.name, index, at: found.at };
  });
  return best;
}

export function pickPlanRegion(plan: PlanEvent, region: Region, filter: PlanFilter): Selection {
  return makeSelection({
    points: filter.points ? plan.points.filter((p) => region.point(p.at_mm)).map((p) => p.name) : [],
    rods: filter.rods ? plan.rods.filter((r) => region.line(r.line_mm)).map((r) => r.name) : [],
  });
}
