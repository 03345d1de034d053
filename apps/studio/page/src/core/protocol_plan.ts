// The plan as events carry it, and the edits that change it.

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
  /** Factor of the stiffness against bending; 0: none. */
  bending: number;
  holes_mm: Vec2[];
  /** Names of rods; empty: found by lissom. */
  outline: string[];
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
  | { name: 'split_rod'; rod: string; point?: string; at_mm?: Vec2 }
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
      bending?: number;
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
