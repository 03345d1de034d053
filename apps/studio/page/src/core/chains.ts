// Rods of the mesh as chains of slots: slot i of a frame is one ring of a tube. Slots run as rod_nodes does.

import type { TopologyPack } from './protocol';

export interface Chains {
  count: number;
  /** Slots before and after, at open ends the slot itself. */
  previous: Uint32Array;
  next: Uint32Array;
  /** Edges before and after a slot, at open ends both the only one. */
  edgeBefore: Uint32Array;
  edgeAfter: Uint32Array;
  /** Number of the rod of a slot. */
  rod: Uint32Array;
  /** Of each rod: its first edge. */
  firstEdge: Uint32Array;
}

export function chainsOf(topology: TopologyPack): Chains {
  const count = topology.rod_nodes.length;
  const chains: Chains = {
    count,
    previous: new Uint32Array(count),
    next: new Uint32Array(count),
    edgeBefore: new Uint32Array(count),
    edgeAfter: new Uint32Array(count),
    rod: new Uint32Array(count),
    firstEdge: new Uint32Array(topology.rods.length + 1),
  };
  let firstEdge = 0;
  topology.rods.forEach((rod, r) => {
    const from = topology.rod_starts[r];
    const nodes = topology.rod_starts[r + 1] - from;
    const edges = rod.closed ? nodes : nodes - 1;
    chains.firstEdge[r] = firstEdge;
    for (let i = 0; i < nodes; ++i) {
      const before = rod.closed ? (i + nodes - 1) % nodes : Math.max(i - 1, 0);
      const after = rod.closed ? (i + 1) % nodes : Math.min(i + 1, nodes - 1);
      chains.previous[from + i] = from + before;
      chains.next[from + i] = from + after;
      chains.edgeBefore[from + i] = firstEdge + (rod.closed ? before : Math.max(i - 1, 0));
      chains.edgeAfter[from + i] = firstEdge + Math.min(i, edges - 1);
      chains.rod[from + i] = r;
    }
    firstEdge += edges;
  });
  chains.firstEdge[topology.rods.length] = firstEdge;
  return chains;
}

/** Writes (slots, 8): place and value, axis n and nothing. Values and axes are means of the edges at a slot. */
export function fillSlots(
  chains: Chains,
  rodNodes: Uint32Array,
  positions: Float32Array,
  normals: Float32Array,
  values: Float32Array | null,
  out: Float32Array,
): void {
  for (let s = 0; s < chains.count; ++s) {
    const node = 3 * rodNodes[s];
    const a = chains.edgeBefore[s];
    const b = chains.edgeAfter[s];
    const at = 8 * s;
    out[at] = positions[node];
    out[at + 1] = positions[node + 1];
    out[at + 2] = positions[node + 2];
    out[at + 3] = values ? 0.5 * (values[a] + values[b]) : 0;
    // n and -n make the same ellipse: neighbours that disagree in sign must not cancel.
    const same = normals[3 * a] * normals[3 * b] + normals[3 * a + 1] * normals[3 * b + 1] + normals[3 * a + 2] * normals[3 * b + 2];
    const sign = same < 0 ? -1 : 1;
    out[at + 4] = normals[3 * a] + sign * normals[3 * b];
    out[at + 5] = normals[3 * a + 1] + sign * normals[3 * b + 1];
    out[at + 6] = normals[3 * a + 2] + sign * normals[3 * b + 2];
  }
}

/** Radii of the slots, (slots, 2), from those of the edges. */
export function slotRadii(chains: Chains, edgeRadii: Float32Array): Float32Array {
  const out = new Float32Array(2 * chains.count);
  for (let s = 0; s < chains.count; ++s) {
    const a = 2 * chains.edgeBefore[s];
    const b = 2 * chains.edgeAfter[s];
    out[2 * s] = 0.5 * (edgeRadii[a] + edgeRadii[b]);
    out[2 * s + 1] = 0.5 * (edgeRadii[a + 1] + edgeRadii[b + 1]);
  }
  return out;
}

/** Attributes and triangles of the tubes: every vertex is (slot, previous slot, next slot, side + 64 * cap), where cap is 0
 *  on the side, 1 or 2 on the rim of the first or last face, 3 or 4 in their middle. Rings are shared by neighbours. */
export function tubeMesh(topology: TopologyPack, chains: Chains, sides: number): { vertices: Float32Array; index: Uint32Array } {
  const open = topology.rods.filter((rod) => !rod.closed).length;
  const rings = chains.count - open;
  const vertices = new Float32Array(4 * (chains.count * sides + 2 * open * (sides + 1)));
  const index = new Uint32Array(6 * rings * sides + 6 * open * sides);
  let v = 0;
  let i = 0;
  const vertex = (slot: number, side: number, cap: number): number => {
    vertices[4 * v] = slot;
    vertices[4 * v + 1] = chains.previous[slot];
    vertices[4 * v + 2] = chains.next[slot];
    vertices[4 * v + 3] = side + 64 * cap;
    return v++;
  };
  const triangle = (a: number, b: number, c: number): void => {
    index[i++] = a;
    index[i++] = b;
    index[i++] = c;
  };
  const face = (slot: number, end: number): void => {
    const rim = v;
    for (let k = 0; k < sides; ++k) vertex(slot, k, end);
    const middle = vertex(slot, 0, end + 2);
    for (let k = 0; k < sides; ++k) triangle(middle, rim + k, rim + ((k + 1) % sides));
  };
  topology.rods.forEach((rod, r) => {
    const from = topology.rod_starts[r];
    const to = topology.rod_starts[r + 1];
    const base = v;
    for (let slot = from; slot < to; ++slot) for (let k = 0; k < sides; ++k) vertex(slot, k, 0);
    for (let j = 0; j < (rod.closed ? to - from : to - from - 1); ++j) {
      const a = base + j * sides;
      const b = base + ((j + 1) % (to - from)) * sides;
      for (let k = 0; k < sides; ++k) {
        const l = (k + 1) % sides;
        triangle(a + k, a + l, b + k);
        triangle(b + k, a + l, b + l);
      }
    }
    if (rod.closed) return;
    face(from, 1);
    face(to - 1, 2);
  });
  return { vertices, index };
}
