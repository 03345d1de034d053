// Makes a rod a ghost (not printed, it only keeps its control points), or a rod again.

import { edit } from '../core/connection';
import { ghosting } from '../core/edits';
import { plan } from '../core/store';
import { clickTool } from './click_tool';

export const ghostTool = clickTool({
  id: 'ghost',
  title: 'Ghost',
  keys: ['Shift+G'],
  icon: 'ghost',
  help: 'Click a rod: it is not printed any more; click again to print it',
  click: ({ hit }) => {
    const now = plan.peek();
    const change = now && hit?.kind === 'rod' ? ghosting(now, [hit.name]) : null;
    if (change) void edit(change);
  },
});
