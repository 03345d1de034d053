// Growing, shrinking, inverting a selection along the rods.

import { forEachEdge } from './picking';
import type { PlanEvent, TopologyPack } from './protocol';
import { makeSelection, type Selection } from './selection';

/** Pairs of neighbours: points along the rods of the plan, nodes along the rods of the mesh. */
function pointPairs(plan: PlanEvent): [string, string][] {
  return plan.rods.flatMap((rod) => {
    const names = rod.points.map((i) => plan.points[i].name);
    const pairs = names.slice(1).map((name, i): [string, string] => [names[i], name]);
    if (rod.closed && names.length > 2) pairs.push([names[names.length - 1], names[0]]);
    return pairs;
  });
}

function nodePairs(topology: TopologyPack): [number, number][] {
  const pairs: [number, number][] = [];
  forEachEdge(topology, (_chain, _edge, a, b) => pairs.push([a, b]));
  return pairs;
}

function grownSet<T>(set: ReadonlySet<T>, pairs: [T, T][]): Set<T> {
  const out = new Set(set);
  for (const [a, b] of pairs) {
    if (set.has(a)) out.add(b);
    if (set.has(b)) out.add(a);
  }
  return out;
}

/** Without those that have a neighbour outside; the ends of rods stay as long as their neighbour does. */
function shrunkSet<T>(set: ReadonlySet<T>, pairs: [T, T][]): Set<T> {
  const out = new Set(set);
  for (const [a, b] of pairs) {
    if (!set.has(a)) out.delete(b);
    if (!set.has(b)) out.delete(a);
  }
  return out;
}

export function grown(selection: Selection, plan: PlanEvent, topology: TopologyPack | null): Selection {
  return {
    points: grownSet(selection.points, pointPairs(plan)),
    rods: selection.rods,
    nodes: topology && selection.nodes.size > 0 ? grownSet(selection.nodes, nodePairs(topology)) : selection.nodes,
  };
}

export function shrunk(selection: Selection, plan: PlanEvent, topology: TopologyPack | null): Selection {
  return {
    points: shrunkSet(selection.points, pointPairs(plan)),
    rods: selection.rods,
    nodes: topology && selection.nodes.size > 0 ? shrunkSet(selection.nodes, nodePairs(topology)) : selection.nodes,
  };
}

export function everything(plan: PlanEvent): Selection {
  return makeSelection({ points: plan.points.map((p) => p.name), rods: plan.rods.map((r) => r.name) });
}

/** What is not selected, of the kinds that are (of all when nothing is). */
export function inverted(selection: Selection, plan: PlanEvent, topology: TopologyPack | null): Selection {
  const all = selection.points.size + selection.rods.size + selection.nodes.size === 0;
  if (all) return everything(plan);
  const not = <T>(set: ReadonlySet<T>, names: T[]) => (set.size > 0 ? names.filter((x) => !set.has(x)) : []);
  const nodes = topology ? [...new Set(topology.rod_nodes)] : [];
  return makeSelection({
    points: not(selection.points, plan.points.map((p) => p.name)),
    rods: not(selection.rods, plan.rods.map((r) => r.name)),
    nodes: not(selection.nodes, nodes),
  });
}

/** Points that a selection means: its own, else those of its rods. */
export function pointsOf(selection: Selection, plan: PlanEvent): string[] {
  if (selection.points.size > 0) return [...selection.points];
  const names = plan.rods.filter((rod) => selection.rods.has(rod.name)).flatMap((rod) => rod.points.map((i) => plan.points[i].name));
  return [...new Set(names)];
}
