// Edits that several places make, as functions of what is selected.

import type { Constraints, Edit, PlanEvent, PlanRod, Vec2 } from './protocol';
import { pointsOf } from './growth';
import type { Selection } from './selection';

export function removal(selection: Selection): Edit | null {
  const points = [...selection.points];
  const rods = [...selection.rods];
  if (points.length + rods.length === 0) return null;
  return { name: 'remove', ...(points.length > 0 && { points }), ...(rods.length > 0 && { rods }) };
}

/** Rods become ghosts; when all are, rods again. */
export function ghosting(plan: PlanEvent, rods: readonly string[]): Edit | null {
  const chosen = plan.rods.filter((rod) => rods.includes(rod.name));
  if (chosen.length === 0) return null;
  return { name: 'set_role', rods: chosen.map((r) => r.name), role: chosen.every((r) => r.role === 'ghost') ? 'rod' : 'ghost' };
}

/** Points become kinks; when all are, smooth again. */
export function kinking(plan: PlanEvent, points: readonly string[]): Edit | null {
  const chosen = plan.points.filter((p) => points.includes(p.name));
  if (chosen.length === 0) return null;
  return { name: 'set_split', points: chosen.map((p) => p.name), split: !chosen.every((p) => p.split) };
}

export function nudge(plan: PlanEvent, selection: Selection, by: Vec2): { point: string; to_mm: Vec2 }[] {
  const names = new Set(pointsOf(selection, plan));
  return plan.points
    .filter((p) => names.has(p.name))
    .map((p) => ({ point: p.name, to_mm: [p.at_mm[0] + by[0], p.at_mm[1] + by[1]] }));
}

/** Pins are toggled: those that all have one lose it. */
export function pinning(plan: PlanEvent, points: readonly string[]): Edit | null {
  if (points.length === 0) return null;
  const { pinned } = plan.constraints;
  const all = points.every((name) => pinned.includes(name));
  const kept = pinned.filter((name) => !points.includes(name));
  return constraints({ pinned: all ? kept : [...kept, ...points] });
}

/** A pair is held together; a pair that is already is let go. */
export function attaching(plan: PlanEvent, a: string, b: string): Edit {
  const others = plan.constraints.attached.filter(([c, d]) => !((c === a && d === b) || (c === b && d === a)));
  const had = others.length < plan.constraints.attached.length;
  return constraints({ attached: had ? others : [...others, [a, b]] });
}

function constraints(change: Partial<Constraints>): Edit {
  return { name: 'set_constraints', ...change };
}

/** The rod that has a point within it (not at an end), those that are selected first. */
export function rodThrough(plan: PlanEvent, point: string, selection: Selection): PlanRod | undefined {
  const index = plan.points.findIndex((p) => p.name === point);
  const within = plan.rods.filter((rod) => {
    const at = rod.points.indexOf(index);
    return at >= 0 && (rod.closed || (at > 0 && at < rod.points.length - 1));
  });
  return within.find((rod) => selection.rods.has(rod.name)) ?? within[0];
}
