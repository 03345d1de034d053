// Select and move: click, Shift adds, Ctrl removes, dragging what is selected moves it, dragging over nothing draws a box
// (left to right: inside; right to left: touching).

import { edit } from '../core/connection';
import { nudge } from '../core/edits';
import { pointsOf } from '../core/growth';
import { pickPlanRegion } from '../core/plan_picking';
import type { Vec2 } from '../core/protocol';
import { boxRegion } from '../core/regions';
import { emptySelection, isEmpty, join, makeSelection } from '../core/selection';
import { emptySketch, planMarquee, sketch } from '../core/sketch';
import { gridStep, lookOnly, plan, selection, selectionFilter, toolHint } from '../core/store';
import { movesNow, PointDrag } from './move';
import type { PlanPointer, Tool } from './tool';

/** Pixels that the pointer may tremble before a click becomes a drag. */
const kTremble = 3;

type Press =
  | { kind: 'box'; from: Vec2 }
  | { kind: 'move'; from: Vec2; grabbed: Vec2; names: string[]; drag: PointDrag | null };

let press: Press | null = null;

function down(pointer: PlanPointer): void {
  const { hit } = pointer;
  if (!hit) {
    press = { kind: 'box', from: pointer.at };
    return;
  }
  const picked = hit.kind === 'point' ? makeSelection({ points: [hit.name] }) : makeSelection({ rods: [hit.name] });
  const now = selection.peek();
  const held = hit.kind === 'point' ? now.points.has(hit.name) : now.rods.has(hit.name);
  if (pointer.join !== 'replace' || !held) selection.value = join(now, picked, pointer.join);
  const { value: structure } = plan;
  if (!structure || pointer.join === 'remove' || lookOnly.peek()) return;
  const names = hit.kind === 'point' && !held && pointer.join === 'replace' ? [hit.name] : pointsOf(selection.peek(), structure);
  press = { kind: 'move', from: pointer.at, grabbed: hit.at, names, drag: null };
}

function move(pointer: PlanPointer): void {
  if (!press || !pointer.pressed) return;
  const far = Math.hypot(pointer.at[0] - press.from[0], pointer.at[1] - press.from[1]) > kTremble * pointer.pixel_mm;
  if (press.kind === 'box') {
    const [a, b] = [press.from, pointer.at];
    if (far || planMarquee.peek()) planMarquee.value = { corners: [a, [b[0], a[1]], b, [a[0], b[1]]], touching: b[0] < a[0] };
    return;
  }
  const { value: structure } = plan;
  if (!structure || (!far && !press.drag)) return;
  press.drag ??= new PointDrag(structure, press.names, press.grabbed);
  const to = pointer.snap.at;
  press.drag.to(to, pointer.time);
  const [dx, dy] = [to[0] - press.grabbed[0], to[1] - press.grabbed[1]];
  const text = `${Math.hypot(dx, dy).toFixed(2)} mm  (${dx.toFixed(2)}, ${dy.toFixed(2)})`;
  sketch.value = { ...emptySketch, guide: pointer.snap.guide, cursor: to, texts: [{ at: to, text }] };
}

function up(pointer: PlanPointer): void {
  const done = press;
  press = null;
  sketch.value = emptySketch;
  if (done?.kind === 'move') {
    void done.drag?.end();
    return;
  }
  if (done?.kind !== 'box') return;
  const boxed = planMarquee.peek() !== null;
  planMarquee.value = null;
  const { value: structure } = plan;
  if (!structure) return;
  const picked = boxed ? pickPlanRegion(structure, boxRegion(done.from, pointer.at), selectionFilter.peek()) : emptySelection;
  if (boxed || pointer.join === 'replace') selection.value = join(selection.peek(), picked, pointer.join);
}

function give(): void {
  if (press?.kind === 'move') press.drag?.cancel();
  press = null;
  planMarquee.value = null;
  sketch.value = emptySketch;
}

const kArrows: Record<string, Vec2> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

function key(event: KeyboardEvent): boolean {
  if (event.key === 'Escape') {
    if (!press && isEmpty(selection.peek())) return false;
    if (press) give();
    else selection.value = emptySelection;
    return true;
  }
  const arrow = kArrows[event.key];
  const structure = plan.peek();
  if (!arrow || !structure || isEmpty(selection.peek()) || lookOnly.peek() || event.ctrlKey || event.metaKey) return false;
  const step = event.shiftKey ? gridStep.peek() : gridStep.peek() / 10;
  const moves = movesNow(nudge(structure, selection.peek(), [arrow[0] * step, arrow[1] * step]));
  if (moves.length > 0) void edit({ name: 'move_points', moves });
  return moves.length > 0;
}

export const selectTool: Tool = {
  id: 'select',
  title: 'Select and move',
  keys: ['V', 'B'],
  icon: 'select',
  help: 'Click selects, Shift adds, Ctrl removes; drag moves; drag over nothing draws a box',
  modes: ['draw', 'explore', 'shape', 'make'],
  except: () => new Set(press?.kind === 'move' ? press.names : []),
  start: () => (toolHint.value = ''),
  stop: give,
  down,
  move,
  up,
  key,
};
