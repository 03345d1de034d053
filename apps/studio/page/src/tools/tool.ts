// What a tool is: it gets pointer and keys of the plan or of the 3D view while it is active.

import type { WorkMode } from '../core/store';

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
}
