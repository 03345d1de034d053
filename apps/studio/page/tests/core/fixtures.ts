// A small plan and its mesh: a square rod, one rod across it, a ghost.

import type { PlanEvent, PlanRod, ShapePack, TopologyPack, Vec2 } from '../../src/core/protocol';

const places: Record<string, Vec2> = { a: [0, 0], b: [10, 0], c: [10, 10], d: [0, 10], m: [5, 5] };
export const names = Object.keys(places);

function rod(name: string, points: string[], closed = false, role: PlanRod['role'] = 'rod'): PlanRod {
  const line = points.map((p) => places[p]);
  return {
    name,
    points: points.map((p) => names.indexOf(p)),
    curve: 'straight',
    role,
    closed,
    length_mm: 10,
    line_mm: closed ? [...line, line[0]] : line,
  };
}

export function plan(): PlanEvent {
  return {
    event: 'plan',
    revision: 1,
    points: names.map((name) => ({ name, at_mm: places[name], r_n_mm: 0.4, r_b_mm: 1.2, split: false })),
    rods: [rod('rim', ['a', 'b', 'c', 'd'], true), rod('cross', ['a', 'm', 'c']), rod('shade', ['b', 'd'], false, 'ghost')],
    material: 'PLA',
    edge_length_mm: 1,
    max_turn_deg: 10,
    fabric: {
      material: 'knit',
      pre_stretch: [1.4, 1.4],
      warp_angle_deg: 0,
      edge_length_mm: 1,
      min_angle_deg: 20,
      bending: 1,
      holes_mm: [],
      outline: ['rim'],
    },
    constraints: { pinned: [], attached: [], in_plane: [], symmetric: null },
  };
}

/** Nodes 0 to 4 are a, b, c, d, m. */
export function topology(): TopologyPack {
  return {
    pack: 'topology',
    sequence: 1,
    topology: 7,
    plan_revision: 1,
    rods: [
      { name: 'rim', plan_rod: 'rim', closed: true },
      { name: 'cross', plan_rod: 'cross', closed: false },
    ],
    plan_places: Float32Array.from(names.flatMap((n) => places[n])),
    triangles: Uint32Array.of(0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4),
    rod_starts: Uint32Array.of(0, 4, 7),
    rod_nodes: Uint32Array.of(0, 1, 2, 3, 0, 4, 2),
    edge_radii: Float32Array.from({ length: 12 }, (_, i) => (i % 2 === 0 ? 0.4 : 1.2)),
    ghost_starts: Uint32Array.of(0, 2),
    ghost_nodes: Uint32Array.of(1, 3),
    point_nodes: Uint32Array.of(0, 1, 2, 3, 4),
    rim: Uint32Array.of(0, 1, 1, 2, 2, 3, 3, 0),
  };
}

export function shape(height = 3): ShapePack {
  const field = { name: 'strain', unit: '%', low: -1, high: 2, diverging: true };
  return {
    pack: 'shape',
    sequence: 2,
    topology: 7,
    residual_n: 1e-7,
    settled: true,
    drag: 0,
    plan_revision: 1,
    field_rods: field,
    field_fabric: { ...field, name: 'stretch', low: 1.1, high: 1.4, diverging: false },
    positions: Float32Array.from(names.flatMap((n) => [...places[n], n === 'm' ? height : 0])),
    normals: Float32Array.from({ length: 18 }, (_, i) => (i % 3 === 2 ? 1 : 0)),
    edge_values: Float32Array.of(0, 1, 2, 3, 4, 5),
    triangle_values: Float32Array.of(1.1, 1.2, 1.3, 1.4),
  };
}
