// Cuts a hole into the fabric: the region between rods that is clicked stays empty. A click on its mark fills it again.

import { edit } from '../core/connection';
import { plan } from '../core/store';
import { distance2 } from '../core/vec';
import { clickTool } from './click_tool';

export const holeTool = clickTool({
  id: 'hole',
  title: 'Hole in the fabric',
  keys: [],
  icon: 'hole',
  help: 'Click a region between rods to leave it empty; click its cross to fill it',
  click: ({ at, pixel_mm }) => {
    const holes = plan.peek()?.fabric.holes_mm ?? [];
    const hole = holes.findIndex((h) => distance2(h, at) < 9 * pixel_mm);
    void edit(hole >= 0 ? { name: 'remove_hole', hole } : { name: 'add_hole', at_mm: at });
  },
});
