// Deletes what is clicked.

import { edit } from '../core/connection';
import { clickTool } from './click_tool';

export const eraseTool = clickTool({
  id: 'erase',
  title: 'Delete',
  keys: ['E'],
  icon: 'delete',
  help: 'Click a rod or a point to delete it',
  click: ({ hit }) => {
    if (hit) void edit(hit.kind === 'rod' ? { name: 'remove', rods: [hit.name] } : { name: 'remove', points: [hit.name] });
  },
});
