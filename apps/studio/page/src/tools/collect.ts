// Tools that collect points by clicks and then do something with them: merge, attach.

import { edit } from '../core/connection';
import { attaching } from '../core/edits';
import type { Edit, Vec2 } from '../core/protocol';
import { emptySketch, sketch } from '../core/sketch';
import { lookOnly, plan, toolHint } from '../core/store';
import type { Tool } from './tool';

function collector(
  shown: Pick<Tool, 'id' | 'title' | 'keys' | 'icon' | 'help' | 'modes'>,
  most: number,
  make: (names: string[]) => Edit | null,
): Tool {
  let names: string[] = [];
  let cursor: Vec2 | null = null;
  const places = () => names.flatMap((name) => plan.peek()?.points.filter((p) => p.name === name).map((p) => p.at_mm) ?? []);
  const redraw = () => {
    const line = places();
    const next = cursor && line.length > 0 ? [{ line: [line[line.length - 1], cursor], faint: true }] : [];
    sketch.value = { ...emptySketch, lines: [...(line.length > 1 ? [{ line }] : []), ...next], points: line };
  };
  const clear = () => {
    names = [];
    cursor = null;
    sketch.value = emptySketch;
  };
  const finish = () => {
    const change = names.length > 1 ? make(names) : null;
    clear();
    if (change) void edit(change);
  };
  return {
    ...shown,
    start: () => {
      clear();
      toolHint.value = shown.help;
    },
    stop: clear,
    down: ({ hit }) => {
      if (hit?.kind !== 'point' || names.includes(hit.name) || lookOnly.peek()) return;
      names = [...names, hit.name];
      redraw();
      if (names.length === most) finish();
    },
    move: ({ at, hit }) => {
      cursor = hit?.kind === 'point' ? hit.at : at;
      redraw();
    },
    key: (event) => {
      if (event.key === 'Enter' && names.length > 1) {
        finish();
        return true;
      }
      if ((event.key !== 'Escape' && event.key !== 'Backspace') || names.length === 0) return false;
      names = names.slice(0, -1);
      redraw();
      return true;
    },
  };
}

export const mergeTool = collector(
  {
    id: 'merge',
    title: 'Merge points',
    keys: ['J'],
    icon: 'merge',
    help: 'Click the point that stays, then those that join it; Enter merges',
    modes: ['draw'],
  },
  Infinity,
  (points) => ({ name: 'merge_points', points }),
);

export const attachTool = collector(
  {
    id: 'attach',
    title: 'Attach two points',
    keys: [],
    icon: 'link',
    help: 'Click two points: modes and fits keep them together; again to let go',
    modes: ['draw', 'explore', 'shape'],
  },
  2,
  ([a, b]) => {
    const now = plan.peek();
    return now ? attaching(now, a, b) : null;
  },
);
