// The scene as text: the rows of the tree, in order, from the plan and from which branches are open.

import type { PlanEvent } from '../../core/protocol';
import { fixed, withUnit } from './number_text';
import { sentenceCase } from './words';

export type RowKind = 'group' | 'fabric' | 'hole' | 'rod' | 'point' | 'pin' | 'link' | 'plane' | 'symmetry' | 'shape' | 'set';

export interface Row {
  /** Unique, stable from one plan to the next: "rod:wing". */
  key: string;
  kind: RowKind;
  level: number;
  title: string;
  /** In a few words, at the right. */
  detail: string;
  /** undefined: has nothing inside. */
  open?: boolean;
  /** Place among its siblings, from 1, and their number. */
  place: number;
  siblings: number;
  /** What it selects. */
  points: readonly string[];
  rods: readonly string[];
}

/** A shape that the tree names besides the present one. */
export interface NamedShape {
  key: string;
  title: string;
  detail: string;
}

export interface Scene {
  plan: PlanEvent;
  shapes: readonly NamedShape[];
  sets: ReadonlyArray<{ name: string; points: readonly string[]; rods: readonly string[] }>;
}

interface Branch {
  key: string;
  kind: RowKind;
  title: string;
  detail?: string;
  points?: readonly string[];
  rods?: readonly string[];
  inside?: Branch[];
}

/** Keys of what is open before anyone has touched the tree. */
export const openAtFirst: readonly string[] = ['fabric', 'rods', 'pins', 'links'];

export function treeRows(scene: Scene, open: ReadonlySet<string>): Row[] {
  return rowsOf(branchesOf(scene), open);
}

function rowsOf(roots: readonly Branch[], open: ReadonlySet<string>): Row[] {
  const rows: Row[] = [];
  const visit = (branches: readonly Branch[], level: number) => {
    branches.forEach((branch, k) => {
      const inside = branch.inside ?? [];
      const isOpen = inside.length > 0 ? open.has(branch.key) : undefined;
      rows.push({
        key: branch.key,
        kind: branch.kind,
        level,
        title: branch.title,
        detail: branch.detail ?? '',
        open: isOpen,
        place: k + 1,
        siblings: branches.length,
        points: branch.points ?? [],
        rods: branch.rods ?? [],
      });
      if (isOpen) visit(inside, level + 1);
    });
  };
  visit(roots, 1);
  return rows;
}

function branchesOf({ plan, shapes, sets }: Scene): Branch[] {
  const { constraints, fabric } = plan;
  const places: Branch[] = constraints.in_plane.map((names, k) => ({
    key: `plane:${k}`,
    kind: 'plane',
    title: `Plane ${k + 1}`,
    detail: `${names.length} points`,
    points: names,
  }));
  if (constraints.symmetric) {
    const { axis, at_mm } = constraints.symmetric;
    places.push({ key: 'symmetry', kind: 'symmetry', title: 'Symmetry', detail: `${axis} = ${withUnit(at_mm, 'mm')}` });
  }
  const groups: Branch[] = [
    fabricBranch(fabric),
    group('rods', 'Rods', plan.rods.map((_, r) => rodBranch(plan, r))),
    group('points', 'Points', plan.points.map((point) => pointBranch(plan, point.name, 'point:'))),
    group('pins', 'Pins', constraints.pinned.map((name) => ({ ...pointBranch(plan, name, 'pin:'), kind: 'pin' as const }))),
    group(
      'links',
      'Attachments',
      constraints.attached.map(([a, b]) => ({ key: `link:${a}:${b}`, kind: 'link', title: `${a} to ${b}`, points: [a, b] })),
    ),
    group('planes', 'Planes and symmetry', places),
    group(
      'sets',
      'Named sets',
      sets.map((set) => ({ key: `set:${set.name}`, kind: 'set', title: set.name, points: set.points, rods: set.rods })),
    ),
    group('shapes', 'Shapes', shapes.map((shape) => ({ ...shape, kind: 'shape' as const }))),
  ];
  return groups.filter((branch) => branch.kind === 'fabric' || (branch.inside?.length ?? 0) > 0);
}

function group(key: string, title: string, inside: Branch[]): Branch {
  return { key, kind: 'group', title: `${title} (${inside.length})`, inside };
}

function fabricBranch(fabric: PlanEvent['fabric']): Branch {
  const [a, b] = fabric.pre_stretch;
  const stretch = a === b ? fixed(a, 2) : `${fixed(a, 2)}, ${fixed(b, 2)}`;
  return {
    key: 'fabric',
    kind: 'fabric',
    title: 'Fabric',
    detail: `stretch ${stretch}`,
    inside: fabric.holes_mm.map(([x, y], k) => ({
      key: `hole:${k}`,
      kind: 'hole',
      title: `Hole ${k + 1}`,
      detail: `at ${fixed(x, 1)}, ${fixed(y, 1)} mm`,
    })),
  };
}

function rodBranch(plan: PlanEvent, r: number): Branch {
  const rod = plan.rods[r];
  const words = [rod.role === 'ghost' ? 'ghost' : '', withUnit(rod.length_mm, 'mm', 0)];
  return {
    key: `rod:${rod.name}`,
    kind: 'rod',
    title: rod.name,
    detail: words.filter((w) => w !== '').join(', '),
    rods: [rod.name],
    inside: rod.points.map((p) => pointBranch(plan, plan.points[p]?.name ?? '', `rod:${rod.name}:`)),
  };
}

function pointBranch(plan: PlanEvent, name: string, prefix: string): Branch {
  const point = plan.points.find((p) => p.name === name);
  const detail = point ? `${fixed(point.at_mm[0], 1)}, ${fixed(point.at_mm[1], 1)} mm` : '';
  return { key: `${prefix}${name}`, kind: 'point', title: name, detail, points: [name] };
}

/** Of a structure without a plan: its rods, by name. */
export function structureRows(rods: readonly string[], open: ReadonlySet<string>): Row[] {
  if (rods.length === 0) return [];
  const inside = rods.map((name, k): Branch => ({ key: `mesh-rod:${k}`, kind: 'rod', title: name }));
  return rowsOf([group('rods', 'Rods', inside)], open);
}

/** Where a key leads in the tree: the key of the row to go to, or whether to open or close the present one. */
export function treeKey(rows: readonly Row[], at: number, key: string): { to: string } | { open: boolean } | undefined {
  const row = rows[at];
  if (!row) return undefined;
  const to = (index: number) => (rows[index] ? { to: rows[index].key } : undefined);
  switch (key) {
    case 'ArrowDown':
      return to(at + 1);
    case 'ArrowUp':
      return to(at - 1);
    case 'Home':
      return to(0);
    case 'End':
      return to(rows.length - 1);
    case 'ArrowRight':
      if (row.open === undefined) return undefined;
      return row.open ? to(at + 1) : { open: true };
    case 'ArrowLeft': {
      if (row.open) return { open: false };
      for (let k = at - 1; k >= 0; --k) if (rows[k].level < row.level) return to(k);
      return undefined;
    }
  }
  if (key.length !== 1 || key === ' ') return undefined;
  const wanted = key.toLowerCase();
  const found = [...rows.slice(at + 1), ...rows.slice(0, at)].find((r) => sentenceCase(r.title).toLowerCase().startsWith(wanted));
  return found ? { to: found.key } : undefined;
}
