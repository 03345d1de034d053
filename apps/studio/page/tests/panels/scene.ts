// A small plan for tests: a rim with a rib and a ghost.

import type { PlanEvent, VerdictEvent } from '../../src/core/protocol';

export function plan(): PlanEvent {
  const point = (name: string, x: number, y: number) => ({ name, at_mm: [x, y] as [number, number], r_n_mm: 0.42, r_b_mm: 1.3, split: false });
  const rod = (name: string, points: number[], role: 'rod' | 'ghost' = 'rod') => ({
    name,
    points,
    curve: 'spline' as const,
    role,
    closed: false,
    length_mm: 100,
    line_mm: [],
  });
  return {
    event: 'plan',
    revision: 1,
    points: [point('a', 0, 0), point('b', 10, 0), point('c', 10, 10), point('free', 5, 5)],
    rods: [rod('rim', [0, 1, 2]), rod('rib', [0, 2], 'ghost')],
    material: 'PLA',
    edge_length_mm: 4,
    max_turn_deg: 20,
    fabric: {
      material: 'knit',
      pre_stretch: [1.4, 1.4],
      warp_angle_deg: 0,
      edge_length_mm: 4,
      min_angle_deg: 20,
      bending: 1,
      holes_mm: [[3, 4]],
      outline: [],
    },
    constraints: { pinned: ['a'], attached: [['a', 'c']], in_plane: [['a', 'b', 'c']], symmetric: { axis: 'x', at_mm: 0 } },
  };
}

export function verdict(change: Partial<VerdictEvent> = {}): VerdictEvent {
  return {
    event: 'verdict',
    name: 'stable',
    sentence: 'settled: every small motion costs energy',
    settled: true,
    residual_n: 3e-7,
    iterations: 2,
    factorizations: 3,
    milliseconds: 62,
    lowest_mode_n_per_m: 0.8,
    negative_modes: 0,
    energy_mj: 12,
    shown: 'settled',
    note: '',
    worst: [],
    ...change,
  };
}
