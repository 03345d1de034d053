// What is selected, as an immutable value: control points and rods by name, mesh nodes by number (of the present topology).

export interface Selection {
  readonly points: ReadonlySet<string>;
  readonly rods: ReadonlySet<string>;
  readonly nodes: ReadonlySet<number>;
}

export const emptySelection: Selection = { points: new Set(), rods: new Set(), nodes: new Set() };

/** What the pointer is on. `at_mm` and `text` are for the label beside it. */
export interface Hover {
  kind: 'point' | 'rod' | 'node' | 'triangle' | 'edge';
  /** Name of the point or rod; for nodes, triangles and edges their number in `index`. */
  name: string;
  index: number;
  text?: string;
}

export type SelectionPart = { points?: Iterable<string>; rods?: Iterable<string>; nodes?: Iterable<number> };

export function makeSelection(part: SelectionPart): Selection {
  return { points: new Set(part.points ?? []), rods: new Set(part.rods ?? []), nodes: new Set(part.nodes ?? []) };
}

export function isEmpty(selection: Selection): boolean {
  return selection.points.size + selection.rods.size + selection.nodes.size === 0;
}

export function size(selection: Selection): number {
  return selection.points.size + selection.rods.size + selection.nodes.size;
}

export function union(a: Selection, b: Selection): Selection {
  return {
    points: new Set([...a.points, ...b.points]),
    rods: new Set([...a.rods, ...b.rods]),
    nodes: new Set([...a.nodes, ...b.nodes]),
  };
}

export function difference(a: Selection, b: Selection): Selection {
  return {
    points: new Set([...a.points].filter((x) => !b.points.has(x))),
    rods: new Set([...a.rods].filter((x) => !b.rods.has(x))),
    nodes: new Set([...a.nodes].filter((x) => !b.nodes.has(x))),
  };
}

/** How a pick joins what was selected: Shift adds, Ctrl (or Cmd) removes, neither replaces. */
export type Join = 'replace' | 'add' | 'remove';

export function joinOf(keys: { shiftKey: boolean; ctrlKey: boolean; metaKey: boolean }): Join {
  if (keys.ctrlKey || keys.metaKey) return 'remove';
  return keys.shiftKey ? 'add' : 'replace';
}

export function join(before: Selection, picked: Selection, how: Join): Selection {
  if (how === 'add') return union(before, picked);
  if (how === 'remove') return difference(before, picked);
  return picked;
}
