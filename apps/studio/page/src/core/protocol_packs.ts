// Packs: arrays are views into the message, never copies.

export interface FieldInfo {
  name: string;
  unit: string;
  low: number;
  high: number;
  diverging: boolean;
}

export interface TopologyPack {
  pack: 'topology';
  sequence: number;
  topology: number;
  plan_revision: number;
  /** `plan_rod`: the engine sends the number of the plan's rod, core/apply.ts puts its name in its place. */
  rods: { name: string; plan_rod: string; closed: boolean }[];
  /** (nodes, 2) mm in the flat plan. */
  plan_places: Float32Array;
  /** (triangles, 3). */
  triangles: Uint32Array;
  /** (rods + 1) offsets into rod_nodes. */
  rod_starts: Uint32Array;
  rod_nodes: Uint32Array;
  /** (edges, 2): r_n, r_b in mm; edges run rod by rod. */
  edge_radii: Float32Array;
  ghost_starts: Uint32Array;
  ghost_nodes: Uint32Array;
  /** Node of each control point of the plan; kNoNode where there is none. */
  point_nodes: Uint32Array;
  /** (segments, 2): edges of the fabric's border. */
  rim: Uint32Array;
}

export const kNoNode = 4294967295;

export interface ShapePack {
  pack: 'shape' | 'flat';
  sequence: number;
  topology: number;
  residual_n: number;
  settled: boolean;
  drag: number;
  plan_revision: number;
  field_rods: FieldInfo;
  field_fabric: FieldInfo;
  /** (nodes, 3) mm. */
  positions: Float32Array;
  /** (edges, 3): material axis n. */
  normals: Float32Array;
  edge_values: Float32Array;
  triangle_values: Float32Array;
  /** Only when radii have changed. */
  edge_radii?: Float32Array;
}

export interface PreviewPack {
  pack: 'preview';
  sequence: number;
  topology: number;
  drag: number;
  residual_n: number | null;
  stale: boolean;
  milliseconds: number;
  changes: { parameter: string; unit: string; from: number; to: number; at_bound: boolean }[];
  rms_mm: number;
  positions: Float32Array;
  normals: Float32Array;
  /** (nodes with a weight, 4) when the engine sends only those, else (nodes, 4): wanted place and weight. */
  target: Float32Array;
}

export interface ModesPack {
  pack: 'modes';
  sequence: number;
  topology: number;
  values: number[];
  /** (modes * nodes, 3) mm, largest entry 1. */
  displacements: Float32Array;
}

export interface BranchesPack {
  pack: 'branches';
  sequence: number;
  topology: number;
  /** (branches * nodes, 3) mm. */
  positions: Float32Array;
}

export type Pack = TopologyPack | ShapePack | PreviewPack | ModesPack | BranchesPack;
