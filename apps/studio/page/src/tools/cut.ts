// Cuts a rod in two: at a control point, or anywhere, where it gets a point first.

import { edit } from '../core/connection';
import { rodThrough } from '../core/edits';
import type { Vec2 } from '../core/protocol';
import { fault, plan, selection } from '../core/store';
import { distance2 } from '../core/vec';
import { clickTool } from './click_tool';

async function cutAt(rod: string, at: Vec2): Promise<void> {
  const answer = await edit({ name: 'insert_point', rod, at_mm: at });
  const now = plan.peek();
  const line = now?.rods.find((r) => r.name === rod);
  if (!answer.ok || !now || !line) return;
  const [nearest] = line.points.map((i) => now.points[i]).sort((a, b) => distance2(a.at_mm, at) - distance2(b.at_mm, at));
  if (nearest) await edit({ name: 'split_rod', rod, point: nearest.name });
}

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
      void cutAt(hit.name, snap.kind === 'free' ? hit.at : snap.at);
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
