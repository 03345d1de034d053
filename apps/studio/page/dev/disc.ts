// The mesh of the stand-in: rings of a disc, its border one closed rod, two straight rods across.

import type { PlanEvent, Vec2 } from '../src/core/protocol';

const kRings = 24;
const kSpokes = 48;

export interface Disc {
  rods: { name: string; plan_rod: string; closed: boolean }[];
  arrays: { name: string; data: Float32Array | Uint32Array; columns?: number }[];
  places: Float32Array;
  triangles: Uint32Array;
  chains: number[][];
}

const node = (ring: number, spoke: number) => (ring === 0 ? 0 : 1 + (ring - 1) * kSpokes + (spoke % kSpokes));

export function discMesh(): Disc {
  const places: number[] = [0, 0];
  for (let r = 1; r <= kRings; ++r) {
    for (let s = 0; s < kSpokes; ++s) {
      const a = (2 * Math.PI * s) / kSpokes;
      places.push(((90 * r) / kRings) * Math.cos(a), ((90 * r) / kRings) * Math.sin(a));
    }
  }
  const triangles: number[] = [];
  for (let s = 0; s < kSpokes; ++s) {
    triangles.push(0, node(1, s), node(1, s + 1));
    for (let r = 1; r < kRings; ++r) {
      triangles.push(node(r, s), node(r + 1, s), node(r, s + 1), node(r, s + 1), node(r + 1, s), node(r + 1, s + 1));
    }
  }
  const across = (s: number) => [
    ...Array.from({ length: kRings }, (_, i) => node(kRings - i, s + kSpokes / 2)),
    ...Array.from({ length: kRings + 1 }, (_, i) => node(i, s)),
  ];
  const chains = [Array.from({ length: kSpokes }, (_, s) => node(kRings, s)), across(0), across(kSpokes / 4)];
  const starts = [0];
  for (const chain of chains) starts.push(starts[starts.length - 1] + chain.length);
  const edges = kSpokes + 2 * (2 * kRings);
  const rim = Array.from({ length: kSpokes }, (_, s) => [node(kRings, s), node(kRings, s + 1)]).flat();
  const pointNodes = [0, ...Array.from({ length: 8 }, (_, k) => node(kRings, (k * kSpokes) / 8))];
  return {
    rods: ['rim', 'across', 'along'].map((name, i) => ({ name, plan_rod: name, closed: i === 0 })),
    places: Float32Array.from(places),
    triangles: Uint32Array.from(triangles),
    chains,
    arrays: [
      { name: 'plan_places', data: Float32Array.from(places), columns: 2 },
      { name: 'triangles', data: Uint32Array.from(triangles), columns: 3 },
      { name: 'rod_starts', data: Uint32Array.from(starts) },
      { name: 'rod_nodes', data: Uint32Array.from(chains.flat()) },
      { name: 'edge_radii', data: new Float32Array(2 * edges).map((_, i) => (i % 2 === 0 ? 0.65 : 1.3)), columns: 2 },
      { name: 'ghost_starts', data: Uint32Array.of(0, kRings + 1) },
      { name: 'ghost_nodes', data: Uint32Array.from({ length: kRings + 1 }, (_, i) => node(i, kSpokes / 8)) },
      { name: 'point_nodes', data: Uint32Array.from(pointNodes) },
      { name: 'rim', data: Uint32Array.from(rim), columns: 2 },
    ],
  };
}

/** A saddle whose height goes with how far the points have moved; `height` fixes it. */
export function saddle(disc: Disc, points: Map<string, Vec2>, height?: number) {
  let pull = 0;
  for (const [name, at] of points) if (name !== 'c') pull += Math.hypot(...at) - 90;
  const rise = height ?? 26 + 0.2 * pull;
  const count = disc.places.length / 2;
  const positions = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) {
    const x = disc.places[2 * i] / 90;
    const y = disc.places[2 * i + 1] / 90;
    positions.set([90 * x * 0.94, 90 * y * 0.94, rise * (x * x - y * y)], 3 * i);
  }
  const edges: [number, number][] = disc.chains.flatMap((chain, c) => {
    const pairs = chain.slice(1).map((b, i): [number, number] => [chain[i], b]);
    return c === 0 ? [...pairs, [chain[chain.length - 1], chain[0]] as [number, number]] : pairs;
  });
  const normals = new Float32Array(3 * edges.length).map((_, i) => (i % 3 === 2 ? 1 : 0));
  const edgeValues = Float32Array.from(edges, (_, i) => -0.05 + (0.07 * i) / edges.length);
  const triangleValues = Float32Array.from({ length: disc.triangles.length / 3 }, (_, t) => 1.38 - 0.004 * (rise / 26) * Math.hypot(disc.places[2 * disc.triangles[3 * t]], disc.places[2 * disc.triangles[3 * t] + 1]));
  return { positions, normals, edgeValues, triangleValues };
}

export function planOf(points: Map<string, Vec2>, revision: number): PlanEvent {
  const names = [...points.keys()];
  const at = (name: string) => points.get(name) ?? [0, 0];
  const circle = Array.from({ length: 8 }, (_, k) => `p${k}`);
  const rod = (name: string, through: string[], closed: boolean, role: 'rod' | 'ghost' = 'rod') => {
    const line = through.map(at);
    return { name, points: through.map((p) => names.indexOf(p)), curve: 'spline' as const, role, closed, length_mm: 180, line_mm: closed ? smooth(line) : line };
  };
  return {
    event: 'plan',
    revision,
    points: names.map((name) => ({ name, at_mm: at(name), r_n_mm: 0.65, r_b_mm: 1.3, split: false })),
    rods: [rod('rim', circle, true), rod('across', ['p4', 'c', 'p0'], false), rod('along', ['p6', 'c', 'p2'], false), rod('ghost', ['c', 'p1'], false, 'ghost')],
    material: 'PLA',
    edge_length_mm: 4,
    max_turn_deg: 20,
    fabric: { material: 'knit', pre_stretch: [1.4, 1.4], warp_angle_deg: 0, edge_length_mm: 4, min_angle_deg: 20, bending: 1, holes_mm: [], outline: ['rim'] },
    constraints: { pinned: ['p0'], attached: [['p1', 'p3']], in_plane: [], symmetric: null },
  };
}

function smooth(line: Vec2[]): Vec2[] {
  return line.flatMap((b, i) => {
    const [a, c, d] = [line[(i + line.length - 1) % line.length], line[(i + 1) % line.length], line[(i + 2) % line.length]];
    return Array.from({ length: 8 }, (_, k): Vec2 => {
      const t = k / 8;
      const at = (j: 0 | 1) => 0.5 * (2 * b[j] + (c[j] - a[j]) * t + (2 * a[j] - 5 * b[j] + 4 * c[j] - d[j]) * t * t + (3 * b[j] - a[j] - 3 * c[j] + d[j]) * t ** 3);
      return [at(0), at(1)];
    });
  });
}
