// What the active tool has drawn so far, over the plan: not yet part of the design.

import { signal } from '@preact/signals-core';
import type { Vec2 } from './protocol';

export interface Sketch {
  lines: { line: Vec2[]; closed?: boolean; faint?: boolean }[];
  points: Vec2[];
  texts: { at: Vec2; text: string }[];
  /** Where a click would go, with the guide that explains it. */
  cursor: Vec2 | null;
  guide: [Vec2, Vec2] | null;
}

export const emptySketch: Sketch = { lines: [], points: [], texts: [], cursor: null, guide: null };
export const sketch = signal<Sketch>(emptySketch);
/** Box or lasso over the plan, mm. */
export const planMarquee = signal<{ corners: Vec2[]; touching: boolean } | null>(null);
