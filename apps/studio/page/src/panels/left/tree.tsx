// The tree: the scene as text, in step with both views. Arrows move, Enter or Space selects, Shift adds, Ctrl removes.

import { effect, useComputed, useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { join, joinOf, makeSelection, type Selection } from '../../core/selection';
import { branches, hover, namedSets, plan, selection, show, previousShape, flatShape, topology } from '../../core/store';
import { fixed } from '../logic/number_text';
import { openAtFirst, structureRows, treeKey, treeRows, type NamedShape, type Row } from '../logic/tree_rows';
import { TreeRow } from './tree_row';

export function Tree() {
  const open = useSignal<ReadonlySet<string>>(new Set(openAtFirst));
  const active = useSignal('fabric');
  const list = useRef<HTMLUListElement>(null);
  const rows = useComputed(() => {
    if (!plan.value) return structureRows(topology.value?.rods.map((rod) => rod.name) ?? [], open.value);
    const sets = Object.entries(namedSets.value).map(([name, set]) => ({ name, points: [...set.points], rods: [...set.rods] }));
    return treeRows({ plan: plan.value, shapes: namedShapes(), sets }, open.value);
  });
  useEffect(() => followHover(list), []);
  useEffect(() => followSelection(list), []);

  const setOpen = (key: string, on: boolean) => {
    const next = new Set(open.peek());
    if (on) next.add(key);
    else next.delete(key);
    open.value = next;
  };
  const pressed = (event: KeyboardEvent) => {
    if (event.ctrlKey && event.key !== ' ') return;
    const shown = rows.peek();
    const at = shown.findIndex((row) => row.key === active.peek());
    const row = shown[at];
    if (row && (event.key === 'Enter' || event.key === ' ')) take(row, event);
    else {
      const move = treeKey(shown, at, event.key);
      if (!move) return;
      if ('open' in move) setOpen(row.key, move.open);
      else {
        active.value = move.to;
        requestAnimationFrame(() => elementOf(list.current, move.to)?.focus());
      }
    }
    event.preventDefault();
    event.stopPropagation();
  };

  const shown = rows.value;
  const reachable = shown.some((row) => row.key === active.value) ? active.value : shown[0]?.key;
  if (shown.length === 0) return <p class="side-empty soft">No plan yet. Open a file or begin with a template.</p>;
  return (
    <ul ref={list} class="tree" role="tree" aria-label="Scene" aria-multiselectable="true" onKeyDown={pressed}>
      {shown.map((row) => (
        <TreeRow
          key={row.key}
          row={row}
          selected={isSelected(row, selection.value)}
          reachable={row.key === reachable}
          onOpen={(on) => setOpen(row.key, on)}
          onTake={(event) => {
            active.value = row.key;
            take(row, event);
          }}
        />
      ))}
    </ul>
  );
}

function take(row: Row, keys: { shiftKey: boolean; ctrlKey: boolean; metaKey: boolean }): void {
  if (row.kind === 'shape') {
    const overlay = row.key === 'shape:flat' ? show.flat : row.key === 'shape:previous' ? show.previous : undefined;
    if (overlay) overlay.value = !overlay.value;
    return;
  }
  selection.value = join(selection.peek(), makeSelection({ points: row.points, rods: row.rods }), joinOf(keys));
}

function isSelected(row: Row, now: Selection): boolean {
  if (row.kind === 'shape') return (row.key === 'shape:flat' && show.flat.value) || (row.key === 'shape:previous' && show.previous.value);
  const count = row.points.length + row.rods.length;
  return count > 0 && row.points.every((p) => now.points.has(p)) && row.rods.every((r) => now.rods.has(r));
}

function namedShapes(): NamedShape[] {
  const shapes: NamedShape[] = [];
  if (flatShape.value) shapes.push({ key: 'shape:flat', title: 'Flat plan', detail: show.flat.value ? 'shown' : 'hidden' });
  if (previousShape.value) shapes.push({ key: 'shape:previous', title: 'Previous shape', detail: show.previous.value ? 'shown' : 'hidden' });
  for (const [k, branch] of (branches.value?.branches ?? []).entries()) {
    const title = branch.present ? 'Present shape' : `Stable shape ${k + 1}`;
    shapes.push({ key: `shape:${k}`, title, detail: `${fixed(branch.energy_mj, 2)} mJ` });
  }
  return shapes;
}

function elementOf(list: HTMLElement | null, key: string): HTMLElement | null {
  return list?.querySelector<HTMLElement>(`[data-key="${CSS.escape(key)}"]`) ?? null;
}

/** Marks the rows of what the pointer is on, wherever it is, without drawing the tree anew. */
function followHover(list: { current: HTMLElement | null }): () => void {
  return effect(() => {
    const now = hover.value;
    list.current?.querySelectorAll('.hovered').forEach((row) => row.classList.remove('hovered'));
    if (now?.kind === 'rod') elementOf(list.current, `rod:${now.name}`)?.classList.add('hovered');
    if (now?.kind !== 'point') return;
    list.current?.querySelectorAll(`[data-point="${CSS.escape(now.name)}"]`).forEach((row) => row.classList.add('hovered'));
  });
}

/** What was selected elsewhere comes into sight here. */
function followSelection(list: { current: HTMLElement | null }): () => void {
  return effect(() => {
    const [rod] = selection.value.rods;
    const [point] = selection.value.points;
    if (list.current?.contains(document.activeElement)) return;
    const key = rod !== undefined ? `rod:${rod}` : point !== undefined ? `point:${point}` : '';
    if (key !== '') requestAnimationFrame(() => elementOf(list.current, key)?.scrollIntoView({ block: 'nearest' }));
  });
}
