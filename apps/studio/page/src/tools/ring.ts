// Draws a ring: press in its middle, drag to its radius.

import { edit } from '../core/connection';
import type { Vec2 } from '../core/protocol';
import { emptySketch, sketch } from '../core/sketch';
import { lookOnly, toolHint } from '../core/store';
import { distance2 } from '../core/vec';
import type { PlanPointer, Tool } from './tool';

/** A closed spline through eight points differs from its circle by less than 0.1 % of the radius. */
const kPoints = 8;
const kHelp = 'Press where the middle of the ring shall be and drag to its radius';

let middle: Vec2 | null = null;

export function ringPoints(center: Vec2, radius: number, count = kPoints): Vec2[] {
  return Array.from({ length: count }, (_, i) => {
    const a = (2 * Math.PI * i) / count;
    return [center[0] + radius * Math.cos(a), center[1] + radius * Math.sin(a)];
  });
}

function move(pointer: PlanPointer): void {
  const at = pointer.snap.at;
  if (!middle || !pointer.pressed) {
    sketch.value = { ...emptySketch, cursor: at, guide: pointer.snap.guide };
    return;
  }
  const radius = distance2(middle, at);
  sketch.value = {
    ...emptySketch,
    lines: [{ line: ringPoints(middle, radius, 72), closed: true }, { line: [middle, at], faint: true }],
    points: [middle],
    cursor: at,
    texts: [{ at, text: `radius ${radius.toFixed(1)} mm` }],
  };
}

function up(pointer: PlanPointer): void {
  const center = middle;
  middle = null;
  sketch.value = emptySketch;
  const radius = center ? distance2(center, pointer.snap.at) : 0;
  if (!center || radius < 3 * pointer.pixel_mm) return;
  void edit({ name: 'add_rod', through: ringPoints(center, radius).map((at_mm) => ({ at_mm })), curve: 'spline', closed: true });
}

export const ringTool: Tool = {
  id: 'ring',
  title: 'Draw a ring',
  keys: ['O'],
  icon: 'ring',
  help: kHelp,
  modes: ['draw'],
  draws: true,
  start: () => (toolHint.value = kHelp),
  stop: () => {
    middle = null;
    sketch.value = emptySketch;
  },
  down: (pointer) => {
    if (!lookOnly.peek()) middle = pointer.snap.at;
  },
  move,
  up,
  key: (event) => {
    if (event.key !== 'Escape' || !middle) return false;
    middle = null;
    sketch.value = emptySketch;
    return true;
  },
};
