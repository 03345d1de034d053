// The one list of what can be done: toolbar, menus, command search, key sheet and keyboard all read it. Register with
// register(), look up with command(id), run with run(id). Keys are written "Ctrl+Shift+Z"; Ctrl means Cmd on a Mac.

import { signal } from '@preact/signals-core';
import { announcement } from './store';

export type CommandGroup = 'File' | 'Edit' | 'Select' | 'Draw' | 'Explore' | 'Shape' | 'Make' | 'View' | 'Solve' | 'Help';

export interface Command {
  /** "edit.undo", "tool.rod", "view.top", "mode.explore", ... */
  id: string;
  /** Sentence case, what it does: "Undo". */
  title: string;
  group: CommandGroup;
  /** Default keys, the first is shown; none: reachable by search and menus only. */
  keys?: string[];
  /** Name of an icon for panels. */
  icon?: string;
  /** Absent: always. Reads signals, so that buttons follow. */
  enabled?: () => boolean;
  /** For switches: whether it is on. */
  checked?: () => boolean;
  /** One more sentence for search and tooltips. */
  help?: string;
  run: () => void;
}

const list = signal<Command[]>([]);

/** All commands in order of registration; reading it in a component follows additions. */
export function commands(): readonly Command[] {
  return list.value;
}

/** Adds commands; one with an id that is known replaces it. */
export function register(...added: Command[]): void {
  const ids = new Set(added.map((c) => c.id));
  list.value = [...list.peek().filter((c) => !ids.has(c.id)), ...added];
}

export function command(id: string): Command | undefined {
  return list.value.find((c) => c.id === id);
}

export function isEnabled(c: Command): boolean {
  return c.enabled?.() ?? true;
}

/** Runs a command by id when it is enabled; says whether it ran. */
export function run(id: string): boolean {
  const found = list.peek().find((c) => c.id === id);
  if (!found || !isEnabled(found)) return false;
  found.run();
  return true;
}

/** Keys that the user has chosen, by id of command; panels' key sheet writes it and it is kept in the browser. */
export const keyOverrides = signal<Record<string, string[]>>({});

export function keysOf(c: Command): string[] {
  return keyOverrides.value[c.id] ?? c.keys ?? [];
}

/** Says a sentence in the live region. */
export function announce(sentence: string): void {
  announcement.value = sentence;
}
