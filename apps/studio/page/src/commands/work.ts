// Commands of the way of working: modes, tools, solving, exploring, handles.

import type { Command } from '../core/commands';
import { send } from '../core/connection';
import { acceptHandle, cancelHandle } from '../core/handles';
import { isEmpty } from '../core/selection';
import { toggleStill } from '../core/still';
import * as store from '../core/store';
import type { WorkMode } from '../core/store';
import { tools } from '../tools/index';

const workModes: { mode: WorkMode; title: string; key: string }[] = [
  { mode: 'draw', title: 'Draw', key: 'Alt+1' },
  { mode: 'explore', title: 'Explore', key: 'Alt+2' },
  { mode: 'shape', title: 'Shape', key: 'Alt+3' },
  { mode: 'make', title: 'Make', key: 'Alt+4' },
];

/** Another mode has other tools; one that it does not have gives way to selecting. */
function work(mode: WorkMode): void {
  store.workMode.value = mode;
  const tool = tools.find((t) => t.id === store.activeTool.peek());
  if (!tool?.modes.includes(mode)) store.activeTool.value = 'select';
}

const editing = () => !store.lookOnly.value;
const held = () => store.handleCenter.value !== null;

export const workCommands: Command[] = [
  ...workModes.map(
    ({ mode, title, key }): Command => ({
      id: `mode.${mode}`,
      title,
      group: 'View',
      keys: [key],
      checked: () => store.workMode.value === mode,
      run: () => work(mode),
    }),
  ),
  ...tools.map(
    (tool): Command => ({
      id: `tool.${tool.id}`,
      title: tool.title,
      group: tool.id === 'select' || tool.id === 'lasso' ? 'Select' : 'Draw',
      keys: tool.keys,
      icon: tool.icon,
      help: tool.help,
      checked: () => store.activeTool.value === tool.id,
      run: () => {
        if (!tool.modes.includes(store.workMode.peek())) store.workMode.value = tool.modes[0];
        store.activeTool.value = tool.id;
      },
    }),
  ),
  {
    id: 'solve.toggle',
    title: 'Run or hold: the shape follows edits, or waits',
    group: 'Solve',
    keys: ['Space'],
    icon: 'play',
    checked: () => store.running.value,
    enabled: editing,
    run: () => {
      store.running.value = !store.running.peek();
      void send({ do: store.running.peek() ? 'run' : 'hold' });
    },
  },
  { id: 'solve.settle', title: 'Settle from here', group: 'Solve', icon: 'play', enabled: editing, run: () => void send({ do: 'settle' }) },
  {
    id: 'solve.release',
    title: 'Release anew from flat',
    group: 'Solve',
    icon: 'reset',
    help: 'The fabric is put flat and let go again',
    enabled: editing,
    run: () => void send({ do: 'settle', from: 'flat' }),
  },
  {
    id: 'explore.modes',
    title: 'Compute modes',
    group: 'Explore',
    keys: ['M'],
    icon: 'modes',
    help: 'The small changes of the plan that change the shape most',
    enabled: editing,
    run: () => {
      work('explore');
      void send({ do: 'modes', count: 6 });
    },
  },
  { id: 'shape.accept', title: 'Make the wanted shape real', group: 'Shape', icon: 'check', enabled: held, run: acceptHandle },
  { id: 'shape.cancel', title: 'Let go of the handle', group: 'Shape', icon: 'close', enabled: held, run: cancelHandle },
  {
    id: 'shape.still',
    title: 'Hold still while something else is pulled, or let go',
    group: 'Shape',
    keys: ['Shift+H'],
    icon: 'lock',
    help: 'What is selected stays where it is, as far as it can; then select what to pull',
    enabled: () => store.workMode.value === 'shape' && editing() && !isEmpty(store.selection.value),
    run: toggleStill,
  },
  ...(['move', 'rotate', 'scale'] as const).map(
    (kind): Command => ({
      id: `shape.${kind}`,
      title: { move: 'Move the handle', rotate: 'Turn the handle', scale: 'Scale the handle' }[kind],
      group: 'Shape',
      keys: [kind === 'move' ? 'G' : kind === 'rotate' ? 'R' : 'S'],
      icon: { move: 'move-3d', rotate: 'rotate', scale: 'scale' }[kind],
      enabled: held,
      checked: () => store.gizmoKind.value === kind,
      run: () => (store.gizmoKind.value = kind),
    }),
  ),
];
