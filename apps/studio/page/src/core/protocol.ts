// Types of everything that page and engine say to each other: docs/studio/protocol.md in TypeScript.
// Lengths in mm, angles in degrees, forces in N, stresses in MPa.

export type Vec2 = [number, number];
export type Vec3 = [number, number, number];

// ---- Plan --------------------------------------------------------------------------------------------------------------

export interface PlanPoint {
  name: string;
  at_mm: Vec2;
  r_n_mm: number;
  r_b_mm: number;
  split: boolean;
}

export type CurveKind = 'spline' | 'straight' | 'arc';
export type RodRole = 'rod' | 'ghost';

export interface PlanRod {
  name: string;
  points: number[];
  curve: CurveKind;
  role: RodRole;
  closed: boolean;
  length_mm: number;
  line_mm: Vec2[];
}

export interface FabricSettings {
  material: string;
  pre_stretch: Vec2;
  warp_angle_deg: number;
  edge_length_mm: number;
  min_angle_deg: number;
  bending: boolean;
  holes_mm: Vec2[];
  outline: string;
}

export interface Symmetry {
  axis: 'x' | 'y';
  at_mm: number;
}

export interface Constraints {
  pinned: string[];
  attached: [string, string][];
  in_plane: string[][];
  symmetric: Symmetry | null;
}

// ---- Edits -------------------------------------------------------------------------------------------------------------

export type Through = { point: string } | { at_mm: Vec2 } | { rod: string; at_mm: Vec2 };

export type Edit =
  | { name: 'move_points'; moves: { point: string; to_mm: Vec2 }[] }
  | { name: 'transform_points'; points: string[]; about_mm: Vec2; move_mm: Vec2; turn_deg: number; scale: Vec2 }
  | {
      name: 'add_rod';
      through: Through[];
      curve?: CurveKind;
      role?: RodRole;
      closed?: boolean;
      rod?: string;
      r_n_mm?: number;
      r_b_mm?: number;
    }
  | { name: 'insert_point'; rod: string; at_mm: Vec2 }
  | { name: 'remove'; points?: string[]; rods?: string[] }
  | { name: 'set_radii'; points: string[]; r_n_mm?: number; r_b_mm?: number; factor?: number }
  | { name: 'set_role'; rods: string[]; role: RodRole }
  | { name: 'set_split'; points: string[]; split: boolean }
  | { name: 'set_curve'; rods: string[]; curve: CurveKind }
  | { name: 'set_closed'; rod: string; closed: boolean }
  | { name: 'split_rod'; rod: string; point: string }
  | { name: 'join_rods'; rods: [string, string] }
  | { name: 'merge_points'; points: string[] }
  | { name: 'rename'; point?: string; rod?: string; to: string }
  | { name: 'mirror'; rods: string[]; axis: 'x' | 'y'; at_mm: number }
  | { name: 'set_pre_stretch'; along: Vec2 }
  | {
      name: 'set_fabric';
      material?: string;
      warp_angle_deg?: number;
      edge_length_mm?: number;
      min_angle_deg?: number;
      bending?: boolean;
    }
  | { name: 'set_rods'; material?: string; edge_length_mm?: number; max_turn_deg?: number }
  | { name: 'add_hole'; at_mm: Vec2 }
  | { name: 'remove_hole'; hole: number }
  | { name: 'strengthen'; pre_stretch_factor: number; radius_factor: number }
  | { name: 'set_title'; title: string }
  | ({ name: 'set_constraints' } & Partial<Constraints>)
  | {
      name: 'set_design';
      points: { point: string; at_mm: Vec2; r_n_mm: number; r_b_mm: number }[];
      pre_stretch: Vec2;
      title: string;
    };

// ---- Requests and their answers ----------------------------------------------------------------------------------------

export type JobName = 'modes' | 'fit' | 'branches' | 'settle' | 'remedy';

export interface HandleMove {
  move_mm: Vec3;
  turn_deg: Vec3;
  scale: number;
}

export type Request =
  | { do: 'hello'; protocol: 1 }
  | { do: 'edit'; edit: Edit }
  | { do: 'drag'; drag: number; edit: Edit }
  | { do: 'drag_end'; drag: number; edit: Edit }
  | { do: 'drag_cancel'; drag: number }
  | { do: 'undo' | 'redo' | 'hold' | 'run' | 'files' | 'handle_accept' | 'handle_cancel' | 'branches' }
  | { do: 'go_to'; step: number }
  | { do: 'new'; template: string }
  | { do: 'open'; file?: string; design?: string }
  | { do: 'save'; file?: string }
  | { do: 'recover'; take: boolean }
  | { do: 'settle'; from?: 'flat' }
  | { do: 'fields'; rods: string; fabric: string }
  | { do: 'modes'; count: number }
  | { do: 'mode_adopt'; mode: number; amplitude_mm: number }
  | { do: 'handle_begin'; nodes?: number[]; points?: string[]; radius_mm: number; held?: number[] }
  | ({ do: 'handle_move' } & HandleMove)
  | { do: 'handle_radius'; radius_mm: number }
  | { do: 'branch_take'; branch: number }
  | { do: 'remedy'; warning: number }
  | { do: 'cancel'; job: JobName }
  | { do: 'export'; format: string; file?: string }
  | { do: 'picture'; file: string; png_base64: string }
  | { do: 'probe'; x: number };

export interface EngineFault {
  code: string;
  where: string;
  message: string;
  hint: string;
}

/** What a request is answered by; the fields beside `id` and `ok` depend on the request. */
export interface Answer {
  id: number;
  ok: boolean;
  error?: EngineFault;
  skipped?: boolean;
  [field: string]: unknown;
}

export interface EditInfo {
  name: string;
  sentence: string;
  fields: unknown;
}

export interface NamedField {
  name: string;
  unit: string;
  sentence: string;
}

/** Answer to `hello`. */
export interface Hello {
  version: string;
  folder: string;
  edits: EditInfo[];
  fields: { rods: NamedField[]; fabric: NamedField[] };
  /** `lines_mm`: the rods of the plan, for drawing. */
  templates: { name: string; title: string; sentence: string; lines_mm?: Vec2[][] }[];
  /** Names. */
  materials: { rods: string[]; fabric: string[] };
}

export interface FileEntry {
  name: string;
  kind: 'plan' | 'structure' | 'project' | 'result' | 'other';
  bytes: number;
  modified: string | number;
}

export interface FilesAnswer {
  files: FileEntry[];
  recent: string[];
  /** `lines_mm`: the rods of the plan, for drawing. */
  designs: { name: string; title: string; points: number; lines_mm?: Vec2[][] }[];
}

export interface HandleAnswer {
  center_mm: Vec3;
  weights: number;
  parameters: number;
}

// ---- Events ------------------------------------------------------------------------------------------------------------

export interface ProjectEvent {
  event: 'project';
  name: string;
  file: string;
  title: string;
  saved: boolean;
  recovery?: { name: string; when: string; steps: number };
  kind: 'plan' | 'structure';
}

export interface PlanEvent {
  event: 'plan';
  revision: number;
  points: PlanPoint[];
  rods: PlanRod[];
  material: string;
  edge_length_mm: number;
  max_turn_deg: number;
  fabric: FabricSettings;
  constraints: Constraints;
}

export interface HistoryEvent {
  event: 'history';
  steps: { title: string; seconds: number }[];
  at: number;
  saved_at: number;
}

export interface Worst {
  what: string;
  where: string;
  value: number;
  unit: string;
  node?: number;
  edge?: number;
  triangle?: number;
}

export interface VerdictEvent {
  event: 'verdict';
  name: string;
  sentence: string;
  settled: boolean;
  residual_n: number;
  iterations: number;
  factorizations: number;
  milliseconds: number;
  lowest_mode_n_per_m: number | null;
  negative_modes: number;
  energy_mj: number;
  shown: 'settled' | 'last good' | 'flat';
  note: string;
  worst: Worst[];
  remedy?: { text: string; edit: Edit };
}

export interface MeasuresEvent {
  event: 'measures';
  height_mm: number;
  box_mm: Vec3;
  area_mm2: number;
  rod_length_mm: number;
  smallest_stretch: number;
  largest_strain: number;
  energy_mj: number;
}

export interface Warning {
  what: string;
  where: string;
  value: number;
  unit: string;
  remedy: string;
  one_click: boolean;
  nodes: number[];
  rod?: string;
  point?: string;
}

export interface WarningsEvent {
  event: 'warnings';
  warnings: Warning[];
}

export interface JobEvent {
  event: 'job';
  job: JobName;
  state: 'running' | 'done' | 'cancelled' | 'failed';
  fraction: number;
  iteration: number;
  value: number;
  unit: string;
  detail: string;
}

export interface ModesEvent {
  event: 'modes';
  stale: boolean;
  modes: { value: number; group: 'points' | 'radii' | 'stretch'; sentence: string }[];
}

export interface HandleEvent {
  event: 'handle';
  active: boolean;
  center_mm: Vec3;
  radius_mm: number;
  stale: boolean;
  sentence: string;
}

export interface FitEvent {
  event: 'fit';
  records: { iteration: number; distance_mm: number; value: number }[];
  before_mm: number;
  after_mm: number;
  at_bounds: string[];
  constraint_mm: number;
  sentence: string;
}

export interface BranchesEvent {
  event: 'branches';
  branches: {
    energy_mj: number;
    height_mm: number;
    lowest_mode_n_per_m: number;
    barrier_free: boolean;
    mirrored: boolean;
    present: boolean;
    sentence: string;
  }[];
}

export interface LogEvent {
  event: 'log';
  text: string;
}

export interface FailedEvent {
  event: 'failed';
  error: EngineFault;
}

export type EngineEvent =
  | ProjectEvent
  | PlanEvent
  | HistoryEvent
  | VerdictEvent
  | MeasuresEvent
  | WarningsEvent
  | JobEvent
  | ModesEvent
  | HandleEvent
  | FitEvent
  | BranchesEvent
  | LogEvent
  | FailedEvent;

// ---- Packs: arrays are views into the message, never copies ------------------------------------------------------------

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
  rods: { name: string; plan_rod: string; closed: boolean }[];
  field_rods: string;
  field_fabric: string;
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
  residual_n: number;
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
