// Pins a control point, or lets it go.

import { edit } from '../core/connection';
import { pinning } from '../core/edits';
import { plan } from '../core/store';
import { clickTool } from './click_tool';

export const pinTool = clickTool({
  id: 'pin',
  title: 'Pin',
  keys: ['Shift+I'],
  icon: 'pin',
  help: 'Click a point: modes and fits leave it where it is; click again to let it go',
  modes: ['draw', 'explore', 'shape'],
  click: ({ hit }) => {
    const now = plan.peek();
    const change = now && hit?.kind === 'point' ? pinning(now, [hit.name]) : null;
    if (change) void edit(change);
  },
});
