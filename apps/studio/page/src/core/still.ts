// Parts that are to stay where they are while another one is pulled.

import { kNoNode, type TopologyPack } from './protocol';
import { difference, emptySelection, isEmpty, size, union, type Selection } from './selection';
import * as store from './store';

/** Nodes of the mesh that a selection means. */
export function nodesOf({ points, rods, nodes }: Selection, mesh: TopologyPack): Set<number> {
  const found = new Set(nodes);
  for (const name of points) {
    const node = mesh.point_nodes[store.pointIndex.peek().get(name) ?? -1] ?? kNoNode;
    if (node !== kNoNode) found.add(node);
  }
  mesh.rods.forEach((rod, i) => {
    if (!rods.has(String(rod.plan_rod))) return;
    for (const node of mesh.rod_nodes.subarray(mesh.rod_starts[i], mesh.rod_starts[i + 1])) found.add(node);
  });
  return found;
}

/** What stays, without what is taken hold of. */
export function stillBeside(taken: Selection): number[] {
  const mesh = store.topology.peek();
  if (!mesh || isEmpty(store.still.peek())) return [];
  const pulled = nodesOf(taken, mesh);
  return [...nodesOf(store.still.peek(), mesh)].filter((node) => !pulled.has(node));
}

/** What is selected stays from now on, and something else can be selected to be pulled; what stays already is let go. */
export function toggleStill(): void {
  const chosen = store.selection.peek();
  const now = store.still.peek();
  const both = union(now, chosen);
  if (size(both) === size(now)) {
    store.still.value = difference(now, chosen);
  } else {
    store.still.value = both;
    store.selection.value = emptySelection;
  }
}
