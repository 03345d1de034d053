// The page's own picture of a soft selection, shown before the engine has answered: weight 1 at what is selected, falling
// to 0 at the soft radius.

import { kNoNode, type TopologyPack } from './protocol';
import type { Selection } from './selection';

/** (1 - (d / r)^2)^2 for d < r: smooth at both ends. */
export function falloff(distance: number, radius: number): number {
  if (distance >= radius) return 0;
  const s = 1 - (distance / radius) ** 2;
  return s * s;
}

/** Nodes that a selection means: its own and those of its points. */
export function nodesOf(selection: Selection, pointIndex: ReadonlyMap<string, number>, topology: TopologyPack): number[] {
  const nodes = new Set(selection.nodes);
  for (const name of selection.points) {
    const index = pointIndex.get(name);
    const node = index === undefined ? kNoNode : topology.point_nodes[index];
    if (node !== undefined && node !== kNoNode) nodes.add(node);
  }
  return [...nodes];
}

/** Weight of every node: by its distance to the nearest selected one. */
export function softWeights(positions: Float32Array, selected: readonly number[], radius: number): Float32Array {
  const out = new Float32Array(positions.length / 3);
  for (let i = 0; i < out.length; ++i) {
    let nearest = Infinity;
    for (const node of selected) {
      const dx = positions[3 * i] - positions[3 * node];
      const dy = positions[3 * i + 1] - positions[3 * node + 1];
      const dz = positions[3 * i + 2] - positions[3 * node + 2];
      nearest = Math.min(nearest, dx * dx + dy * dy + dz * dz);
    }
    out[i] = falloff(Math.sqrt(nearest), radius);
  }
  for (const node of selected) out[node] = 1;
  return out;
}

/** Corners of a circle on the screen's plane: the soft radius as people see it. */
export function ring(center: readonly [number, number], pixels: number, steps = 64): [number, number][] {
  return Array.from({ length: steps + 1 }, (_, i) => {
    const a = (2 * Math.PI * i) / steps;
    return [center[0] + pixels * Math.cos(a), center[1] + pixels * Math.sin(a)];
  });
}
