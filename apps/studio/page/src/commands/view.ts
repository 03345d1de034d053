// Commands of the 3D view and of the plan's picture.

import type { Command } from '../core/commands';
import { zoom } from '../core/camera';
import * as store from '../core/store';
import type { NamedView } from '../core/store';
import { easeTo, fitAll, fitSelection, look } from '../view/camera_motion';

const named: { view: NamedView; title: string; keys: string[] }[] = [
  { view: 'top', title: 'Look from the top', keys: ['7'] },
  { view: 'front', title: 'Look from the front', keys: ['1'] },
  { view: 'right', title: 'Look from the right', keys: ['3'] },
  { view: 'bottom', title: 'Look from below', keys: [] },
  { view: 'back', title: 'Look from the back', keys: [] },
  { view: 'left', title: 'Look from the left', keys: [] },
  { view: 'home', title: 'Home view', keys: [] },
];

const shown: { key: keyof typeof store.show; title: string; keys?: string[] }[] = [
  { key: 'fabric', title: 'Show the fabric', keys: ['H'] },
  { key: 'rods', title: 'Show the rods' },
  { key: 'ghosts', title: 'Show ghost rods' },
  { key: 'points', title: 'Show control points' },
  { key: 'constraints', title: 'Show pins and attachments' },
  { key: 'grid', title: 'Show the grid' },
  { key: 'mesh', title: 'Show the mesh of the fabric' },
  { key: 'flat', title: 'Show the flat plan over the shape' },
  { key: 'previous', title: 'Show the shape before the last step' },
  { key: 'target', title: 'Show where the handle wants the shape' },
  { key: 'preview', title: 'Show the linear preview' },
];

function zoomBy(factor: number): void {
  const size = store.viewSize.peek();
  easeTo(zoom(store.camera.peek(), factor, [size.width / 2, size.height / 2], size));
}

export const viewCommands: Command[] = [
  { id: 'view.fit', title: 'Fit all', group: 'View', keys: ['Home'], icon: 'fit', run: fitAll },
  { id: 'view.fit_selection', title: 'Fit the selection', group: 'View', keys: ['F'], icon: 'fit', run: fitSelection },
  ...named.map(
    ({ view, title, keys }): Command => ({ id: `view.${view}`, title, group: 'View', keys, icon: 'box', run: () => look(view) }),
  ),
  {
    id: 'view.parallel',
    title: 'Parallel projection',
    group: 'View',
    keys: ['5'],
    checked: () => store.orthographic.value,
    run: () => (store.orthographic.value = !store.orthographic.peek()),
  },
  { id: 'view.nearer', title: 'Zoom in', group: 'View', keys: ['PageUp'], run: () => zoomBy(0.8) },
  { id: 'view.farther', title: 'Zoom out', group: 'View', keys: ['PageDown'], run: () => zoomBy(1.25) },
  ...shown.map(
    ({ key, title, keys }): Command => ({
      id: `show.${key}`,
      title,
      group: 'View',
      keys,
      icon: 'eye',
      checked: () => store.show[key].value,
      run: () => (store.show[key].value = !store.show[key].peek()),
    }),
  ),
];
