// What the engine tells everyone.

import type { Constraints, Edit, FabricSettings, PlanPoint, PlanRod, Vec3 } from './protocol_plan';
import type { EngineFault, JobName } from './protocol';
export interface ProjectEvent {
  event: 'project';
  name: string;
  file: string;
  title: string;
  saved: boolean;
  recovery?: { name: string; when: string; steps: number };
  /** "none": nothing is open; then the other fields are absent. */
  kind: 'plan' | 'structure' | 'none';
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
  shown: 'settled' | 'last good' | 'unsettled';
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
