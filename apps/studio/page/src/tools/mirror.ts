// Mirrors the selected rods across a line that stands upright, or lies level after X or Y was pressed.

import { edit } from '../core/connection';
import type { PlanEvent, Symmetry, Vec2 } from '../core/protocol';
import { emptySketch, sketch } from '../core/sketch';
import { lookOnly, plan, selection, toolHint } from '../core/store';
import { mirrored } from '../core/symmetry';
import type { Tool } from './tool';

const kFar = 1e4;
let axis: Symmetry['axis'] = 'x';
let at: Vec2 = [0, 0];

function chosen(now: PlanEvent) {
  const { rods } = selection.peek();
  return rods.size > 0 ? now.rods.filter((rod) => rods.has(rod.name)) : now.rods;
}

function line(): Symmetry {
  return { axis, at_mm: axis === 'x' ? at[0] : at[1] };
}

function redraw(): void {
  const now = plan.peek();
  if (!now) return;
  const { at_mm } = line();
  const guide: [Vec2, Vec2] = axis === 'x' ? [[at_mm, -kFar], [at_mm, kFar]] : [[-kFar, at_mm], [kFar, at_mm]];
  const lines = chosen(now).map((rod) => ({ line: rod.line_mm.map((p) => mirrored(p, line())), faint: true }));
  sketch.value = { ...emptySketch, lines, guide, cursor: at, texts: [{ at, text: `${axis} = ${at_mm.toFixed(1)} mm` }] };
}

export const mirrorTool: Tool = {
  id: 'mirror',
  title: 'Mirror rods',
  keys: ['Shift+M'],
  icon: 'mirror',
  help: 'Click where the mirror line lies; X or Y turns it; selected rods, or all, get mirror images',
  modes: ['draw'],
  draws: true,
  start: () => (toolHint.value = mirrorTool.help),
  stop: () => (sketch.value = emptySketch),
  down: (pointer) => {
    const now = plan.peek();
    at = pointer.snap.at;
    if (!now || lookOnly.peek()) return;
    void edit({ name: 'mirror', rods: chosen(now).map((r) => r.name), axis, at_mm: line().at_mm });
  },
  move: (pointer) => {
    at = pointer.snap.at;
    redraw();
  },
  key: (event) => {
    const letter = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey || (letter !== 'x' && letter !== 'y')) return false;
    axis = letter;
    redraw();
    return true;
  },
};
