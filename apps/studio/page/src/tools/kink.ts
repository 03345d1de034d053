// Makes a control point a kink, or smooth again.

import { edit } from '../core/connection';
import { kinking } from '../core/edits';
import { plan } from '../core/store';
import { clickTool } from './click_tool';

export const kinkTool = clickTool({
  id: 'kink',
  title: 'Kink',
  keys: ['K'],
  icon: 'split',
  help: 'Click a point: its rods may bend sharply there; click again to smooth it',
  click: ({ hit }) => {
    const now = plan.peek();
    const change = now && hit?.kind === 'point' ? kinking(now, [hit.name]) : null;
    if (change) void edit(change);
  },
});
