// Puts a control point into a rod.

import { edit } from '../core/connection';
import { clickTool } from './click_tool';

export const insertTool = clickTool({
  id: 'insert',
  title: 'Insert a point',
  keys: ['I'],
  icon: 'insert',
  help: 'Click a rod where the new point shall be',
  draws: true,
  click: ({ hit, snap }) => {
    const rod = hit?.kind === 'rod' ? hit.name : snap.kind === 'rod' || snap.kind === 'middle' ? snap.name : '';
    if (rod !== '') void edit({ name: 'insert_point', rod, at_mm: snap.kind === 'free' ? (hit?.at ?? snap.at) : snap.at });
  },
});
