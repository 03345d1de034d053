// Cuts a rod in two: at a control point, or anywhere, where it gets a point.

import { edit } from '../core/connection';
import { rodThrough } from '../core/edits';
import { fault, plan, selection } from '../core/store';
import { clickTool } from './click_tool';

export const cutTool = clickTool({
  id: 'cut',
  title: 'Cut a rod',
  keys: ['C'],
  icon: 'cut',
  help: 'Click a point within a rod, or a place on it: the rod becomes two',
  draws: true,
  click: ({ hit, snap }) => {
    const now = plan.peek();
    if (!now || !hit) return;
    if (hit.kind === 'rod') {
      void edit({ name: 'split_rod', rod: hit.name, at_mm: snap.kind === 'free' ? hit.at : snap.at });
      return;
    }
    const rod = rodThrough(now, hit.name, selection.peek());
    if (rod) {
      void edit({ name: 'split_rod', rod: rod.name, point: hit.name });
      return;
    }
    const hint = 'Click a point that has rod on both sides.';
    fault.value = { code: 'conflict', where: hit.name, message: `No rod runs through point ${hit.name}.`, hint };
  },
});
