// Selects what a line drawn by hand goes round, in the plan and in space (view/pointer3d.ts asks for the tool by name).

import { pickPlanRegion } from '../core/plan_picking';
import type { Vec2 } from '../core/protocol';
import { lassoRegion } from '../core/regions';
import { join } from '../core/selection';
import { planMarquee } from '../core/sketch';
import { plan, selection, selectionFilter, toolHint } from '../core/store';
import type { Tool } from './tool';

let path: Vec2[] = [];

function clear(): void {
  path = [];
  planMarquee.value = null;
}

export const lassoTool: Tool = {
  id: 'lasso',
  title: 'Lasso',
  keys: ['L'],
  icon: 'lasso',
  help: 'Draw round what shall be selected; Shift adds, Ctrl removes',
  modes: ['draw', 'explore', 'shape', 'make'],
  start: () => (toolHint.value = lassoTool.help),
  stop: clear,
  down: ({ at }) => (path = [at]),
  move: ({ at, pressed }) => {
    if (!pressed) return;
    path.push(at);
    planMarquee.value = { corners: [...path], touching: false };
  },
  up: (pointer) => {
    const now = plan.peek();
    if (now && path.length > 2) {
      selection.value = join(selection.peek(), pickPlanRegion(now, lassoRegion(path), selectionFilter.peek()), pointer.join);
    }
    clear();
  },
};
