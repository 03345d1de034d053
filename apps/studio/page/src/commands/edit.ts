// Commands that change the design and its history.

import type { Command } from '../core/commands';
import { edit, send } from '../core/connection';
import { ghosting, kinking, pinning, removal } from '../core/edits';
import { pointsOf } from '../core/growth';
import type { Edit } from '../core/protocol';
import * as store from '../core/store';

const { plan, selection } = store;

/** Enabled while the selection gives an edit; runs that edit. */
function changing(make: () => Edit | null): Pick<Command, 'enabled' | 'run'> {
  return {
    enabled: () => !store.lookOnly.value && make() !== null,
    run: () => {
      const change = make();
      if (change) void edit(change);
    },
  };
}

const points = () => (plan.value ? pointsOf(selection.value, plan.value) : []);
const rods = () => [...selection.value.rods];

export const editCommands: Command[] = [
  {
    id: 'edit.undo',
    title: 'Undo',
    group: 'Edit',
    keys: ['Ctrl+Z'],
    icon: 'undo',
    enabled: () => store.canUndo.value && !store.lookOnly.value,
    run: () => void send({ do: 'undo' }),
  },
  {
    id: 'edit.redo',
    title: 'Redo',
    group: 'Edit',
    keys: ['Ctrl+Shift+Z', 'Ctrl+Y'],
    icon: 'redo',
    enabled: () => store.canRedo.value && !store.lookOnly.value,
    run: () => void send({ do: 'redo' }),
  },
  {
    id: 'edit.remove',
    title: 'Delete the selection',
    group: 'Edit',
    keys: ['Delete', 'Backspace'],
    icon: 'delete',
    ...changing(() => removal(selection.value)),
  },
  {
    id: 'edit.ghost',
    title: 'Ghost or rod',
    group: 'Draw',
    icon: 'ghost',
    help: 'Selected rods become ghosts: not printed, but they keep their control points; ghosts become rods',
    ...changing(() => (plan.value ? ghosting(plan.value, rods()) : null)),
  },
  {
    id: 'edit.kink',
    title: 'Kink or smooth',
    group: 'Draw',
    icon: 'split',
    help: 'Rods may bend sharply at the selected points, or not any more',
    ...changing(() => (plan.value ? kinking(plan.value, [...selection.value.points]) : null)),
  },
  {
    id: 'edit.merge',
    title: 'Merge the selected points',
    group: 'Draw',
    icon: 'merge',
    ...changing(() => (selection.value.points.size > 1 ? { name: 'merge_points', points: [...selection.value.points] } : null)),
  },
  {
    id: 'edit.join',
    title: 'Join two rods end to end',
    group: 'Draw',
    icon: 'link',
    ...changing(() => (selection.value.rods.size === 2 ? { name: 'join_rods', rods: rods() as [string, string] } : null)),
  },
  {
    id: 'edit.pin',
    title: 'Pin or let go',
    group: 'Shape',
    icon: 'pin',
    help: 'Modes and fits leave pinned points where they are',
    ...changing(() => (plan.value ? pinning(plan.value, [...selection.value.points]) : null)),
  },
  ...([1.05, 1 / 1.05] as const).map(
    (factor): Command => ({
      id: factor > 1 ? 'edit.thicker' : 'edit.thinner',
      title: factor > 1 ? 'Thicken the selection by 5 %' : 'Thin the selection by 5 %',
      group: 'Draw',
      keys: [factor > 1 ? ']' : '['],
      ...changing(() => (points().length > 0 ? { name: 'set_radii', points: points(), factor } : null)),
    }),
  ),
];
