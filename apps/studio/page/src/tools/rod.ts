// Draw a rod: click by click, snapping to points and rods, its length beside the pointer. Enter or a double click ends
// it, a click on its first point closes it, Esc and Backspace take back one click after the other.

import { edit } from '../core/connection';
import type { RodRole, Through, Vec2 } from '../core/protocol';
import { emptySketch, sketch } from '../core/sketch';
import type { Snap } from '../core/snapping';
import { lookOnly, toolHint } from '../core/store';
import { distance2 } from '../core/vec';
import type { PlanPointer, Tool } from './tool';

interface Click {
  at: Vec2;
  through: Through;
}

let clicks: Click[] = [];
let cursor: Snap | null = null;

function throughOf(snap: Snap): Through {
  if (snap.kind === 'point') return { point: snap.name };
  if (snap.kind === 'rod' || snap.kind === 'middle' || snap.kind === 'tangent') return { rod: snap.name, at_mm: snap.at };
  return { at_mm: snap.at };
}

function length(line: readonly Vec2[]): number {
  return line.slice(1).reduce((sum, p, i) => sum + distance2(line[i], p), 0);
}

function redraw(): void {
  const line = clicks.map((c) => c.at);
  const last = line.at(-1);
  const texts: { at: Vec2; text: string }[] = [];
  if (cursor && last) {
    const all = length([...line, cursor.at]);
    const part = distance2(last, cursor.at);
    texts.push({ at: cursor.at, text: line.length > 1 ? `${part.toFixed(1)} mm, ${all.toFixed(1)} mm in all` : `${part.toFixed(1)} mm` });
  }
  const next = cursor && last ? [{ line: [last, cursor.at], faint: true }] : [];
  const solid = line.length > 1 ? [{ line }] : [];
  sketch.value = { lines: [...solid, ...next], points: line, texts, cursor: cursor?.at ?? null, guide: cursor?.guide ?? null };
  toolHint.value =
    clicks.length === 0 ? 'Click where the rod starts' : clicks.length === 1 ? 'Click the next point; Esc takes back' : 'Click the next point; Enter ends the rod, Esc takes back';
}

function clear(): void {
  clicks = [];
  redraw();
}

async function finish(closed: boolean, role: RodRole): Promise<void> {
  const done = clicks;
  if (done.length < 2 || lookOnly.peek()) return;
  const curve = done.length > 2 ? 'spline' : 'straight';
  // The line stays to be seen until the engine has answered; whatever is clicked or pressed from now on is the next rod's.
  clicks = [];
  await edit({ name: 'add_rod', through: done.map((c) => c.through), curve, role, closed: closed && done.length > 2 });
  if (clicks.length === 0 && cursor) redraw();
}

function down(pointer: PlanPointer, role: RodRole): void {
  const { snap } = pointer;
  cursor = snap;
  const first = clicks[0];
  if (first && clicks.length > 2 && distance2(first.at, pointer.at) < 9 * pointer.pixel_mm) {
    void finish(true, role);
    return;
  }
  const last = clicks.at(-1);
  if (last && distance2(last.at, snap.at) < 1e-6) return;
  clicks = [...clicks, { at: snap.at, through: throughOf(snap) }];
  redraw();
}

function key(event: KeyboardEvent, role: RodRole): boolean {
  if (event.key === 'Enter') {
    const drawing = clicks.length > 0;
    void finish(false, role);
    return drawing;
  }
  if ((event.key !== 'Escape' && event.key !== 'Backspace') || clicks.length === 0) return false;
  clicks = clicks.slice(0, -1);
  redraw();
  return true;
}

function tool(role: RodRole, id: string, title: string, keys: string[], icon: string, help: string): Tool {
  return {
    id,
    title,
    keys,
    icon,
    help,
    modes: ['draw'],
    draws: true,
    from: () => clicks.at(-1)?.at ?? null,
    start: clear,
    stop: () => {
      clear();
      cursor = null;
      sketch.value = emptySketch;
    },
    down: (pointer) => down(pointer, role),
    move: (pointer) => {
      cursor = pointer.snap;
      redraw();
    },
    double: () => void finish(false, role),
    key: (event) => key(event, role),
  };
}

export const rodTool = tool('rod', 'rod', 'Draw a rod', ['P'], 'rod', 'Click from point to point, Enter ends; click the first point to close');
export const ghostRodTool = tool('ghost', 'ghost-rod', 'Draw a ghost rod', ['Shift+P'], 'pen', 'As a rod, but not printed: it only shapes the fabric');
