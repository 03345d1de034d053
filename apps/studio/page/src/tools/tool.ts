// What a tool is: it gets the pointer and the keys of the plan while it is active. Tools that only say how the 3D view
// selects (box, lasso) or that belong to the handle have no pointer of their own.

import type { PlanHit } from '../core/plan_picking';
import type { Vec2 } from '../core/protocol';
import type { Join } from '../core/selection';
import type { Snap } from '../core/snapping';
import type { WorkMode } from '../core/store';

export interface PlanPointer {
  /** Where the pointer is, and where it means to be. */
  at: Vec2;
  snap: Snap;
  hit: PlanHit | null;
  join: Join;
  /** True while the left button is down. */
  pressed: boolean;
  /** Millimetres that a pixel shows. */
  pixel_mm: number;
  /** Time of the event, for measuring how soon it is drawn. */
  time: number;
}

export interface Tool {
  /** "select", "rod", ...; the command that activates it is "tool." + id. */
  id: string;
  title: string;
  /** Keys of the command. */
  keys: string[];
  icon: string;
  help: string;
  /** Modes of work in which toolbars show it. */
  modes: WorkMode[];
  /** The plan shows a crosshair and snaps the hovering pointer. */
  draws?: boolean;
  /** The point before, for angles. */
  from?: () => Vec2 | null;
  /** Names of points that do not hold the pointer, for they move with it. */
  except?: () => ReadonlySet<string>;
  start?: () => void;
  /** Gives up what is under way; called when another tool takes over. */
  stop?: () => void;
  down?: (pointer: PlanPointer) => void;
  move?: (pointer: PlanPointer) => void;
  up?: (pointer: PlanPointer) => void;
  double?: (pointer: PlanPointer) => void;
  /** Says whether the key was one of its own. */
  key?: (event: KeyboardEvent) => boolean;
}
