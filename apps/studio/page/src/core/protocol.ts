// Types of everything that page and engine say to each other: docs/studio/protocol.md in TypeScript.
// Lengths in mm, angles in degrees, forces in N, stresses in MPa. Here: requests and their answers.

import type { Edit, Vec2, Vec3 } from './protocol_plan';

export * from './protocol_events';
export * from './protocol_packs';
export * from './protocol_plan';

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
  | { do: 'save'; file?: string; replace?: boolean }
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
