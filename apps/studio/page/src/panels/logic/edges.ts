// Edges of a mesh run rod by rod; a closed rod has as many as nodes, an open one fewer by one.

import type { TopologyPack } from '../../core/protocol';

type Rods = Pick<TopologyPack, 'rods' | 'rod_starts' | 'rod_nodes'>;

/** First edge of each rod, and their number at the end. */
export function edgeStarts(mesh: Rods): number[] {
  const starts = [0];
  mesh.rods.forEach((rod, r) => {
    const nodes = mesh.rod_starts[r + 1] - mesh.rod_starts[r];
    starts.push(starts[r] + (rod.closed ? nodes : Math.max(0, nodes - 1)));
  });
  return starts;
}

/** The rod of an edge and the two nodes that it joins. */
export function nodesOfEdge(mesh: Rods, edge: number): { rod: number; nodes: [number, number] } | undefined {
  const starts = edgeStarts(mesh);
  const rod = starts.findIndex((start, r) => start <= edge && edge < (starts[r + 1] ?? -1));
  if (rod < 0) return undefined;
  const first = mesh.rod_starts[rod];
  const count = mesh.rod_starts[rod + 1] - first;
  const at = edge - starts[rod];
  return { rod, nodes: [mesh.rod_nodes[first + at], mesh.rod_nodes[first + ((at + 1) % count)]] };
}

/** Values of the edges of the rods that a plan rod has become. */
export function valuesOfRod(mesh: Rods, planRod: string, values: ArrayLike<number>): number[] {
  const starts = edgeStarts(mesh);
  const out: number[] = [];
  mesh.rods.forEach((rod, r) => {
    if (rod.plan_rod !== planRod) return;
    for (let e = starts[r]; e < starts[r + 1]; ++e) out.push(values[e]);
  });
  return out;
}
