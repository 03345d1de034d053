// Commands of the panels: files, pictures, dialogs, layout, look.

import type { Signal } from '@preact/signals';
import { register, type Command } from '../core/commands';
import { send } from '../core/connection';
import {
  connection,
  dialog,
  lookOnly,
  navigation,
  planDock,
  quality,
  theme,
  uiScale,
  type NavigationPreset,
  type PlanDock,
  type Quality,
  type Theme,
} from '../core/store';
import { beginGuide } from './dialogs/guide_bar';
import { save } from './files';
import { sideShown, toggleSide } from './layout_state';
import { writeExport, writePicture } from './make/write';

const open = () => connection.value === 'open';

const files: Command[] = [
  {
    id: 'file.start',
    title: 'New or open',
    group: 'File',
    keys: ['Ctrl+O'],
    icon: 'open',
    help: 'Templates, designs that come with lissom, recent files',
    run: () => (dialog.value = 'start'),
  },
  { id: 'file.save', title: 'Save', group: 'File', keys: ['Ctrl+S'], icon: 'save', enabled: open, run: () => void save() },
  {
    id: 'file.save_as',
    title: 'Save as',
    group: 'File',
    keys: ['Ctrl+Shift+S'],
    icon: 'save',
    enabled: open,
    run: () => (dialog.value = 'save'),
  },
];

const making: Command[] = ['svg', 'dxf', 'stl'].map((format) => ({
  id: `make.${format}`,
  title: `Write ${format.toUpperCase()}`,
  group: 'Make',
  icon: 'export',
  help: 'A file to make it from, into the folder',
  enabled: open,
  run: () => void writeExport(format),
}));

const pictures: Command[] = [true, false].map((legends) => ({
  id: legends ? 'make.picture' : 'make.picture_plain',
  title: legends ? 'Write a picture with its legend' : 'Write a picture without legend',
  group: 'Make',
  icon: 'camera',
  help: 'PNG, twice the size on screen',
  enabled: open,
  run: () => void writePicture(legends),
}));

const explore: Command[] = [
  {
    id: 'explore.branches',
    title: 'Look for other stable shapes',
    group: 'Explore',
    icon: 'compare',
    enabled: () => !lookOnly.value,
    run: () => void send({ do: 'branches' }),
  },
];

const docks: ReadonlyArray<{ dock: PlanDock; title: string }> = [
  { dock: 'below', title: 'Plan below the shape' },
  { dock: 'beside', title: 'Plan beside the shape' },
  { dock: 'full', title: 'Plan alone' },
  { dock: 'hidden', title: 'Shape alone' },
];

const themes: ReadonlyArray<{ value: Theme; title: string }> = [
  { value: 'light', title: 'Light theme' },
  { value: 'dark', title: 'Dark theme' },
  { value: 'system', title: 'Theme of the system' },
];

const presets: ReadonlyArray<{ value: NavigationPreset; title: string }> = [
  { value: 'rhino', title: 'Navigate as in Rhino' },
  { value: 'blender', title: 'Navigate as in Blender' },
  { value: 'cad', title: 'Navigate as in CAD' },
  { value: 'trackpad', title: 'Navigate with a trackpad' },
];

const qualities: ReadonlyArray<{ value: Quality; title: string }> = [
  { value: 'auto', title: 'Draw as the machine allows' },
  { value: 'high', title: 'Draw finely' },
  { value: 'low', title: 'Draw fast' },
];

const scales = [1, 1.25, 1.5, 1.75, 2];

const layout: Command[] = [
  {
    id: 'panel.tree',
    title: 'Tree',
    group: 'View',
    icon: 'panel-left',
    checked: () => sideShown('tree'),
    run: () => toggleSide('tree'),
  },
  {
    id: 'panel.inspector',
    title: 'Inspector',
    group: 'View',
    icon: 'panel-right',
    checked: () => sideShown('inspector'),
    run: () => toggleSide('inspector'),
  },
  ...docks.map(({ dock, title }) => choice('dock', dock, title, planDock)),
  ...themes.map(({ value, title }) => choice('theme', value, title, theme)),
  ...presets.map(({ value, title }) => choice('navigation', value, title, navigation)),
  ...qualities.map(({ value, title }) => choice('quality', value, title, quality)),
  ...scales.map((scale) => choice('scale', scale, `Interface at ${100 * scale} %`, uiScale)),
];

const help: Command[] = [
  {
    id: 'help.commands',
    title: 'Search commands',
    group: 'Help',
    keys: ['Ctrl+K'],
    icon: 'search',
    run: () => (dialog.value = 'commands'),
  },
  { id: 'help.guide', title: 'Show me around', group: 'Help', icon: 'info', help: 'Six things to try', run: beginGuide },
  { id: 'help.keys', title: 'Keys', group: 'Help', keys: ['?'], icon: 'keyboard', run: () => (dialog.value = 'keys') },
  {
    id: 'help.verdict',
    title: 'Say why, and what to do',
    group: 'Help',
    icon: 'info',
    help: 'Verdict, worst places, warnings and remedies',
    run: () => (dialog.value = 'verdict'),
  },
  { id: 'help.about', title: 'About lissom', group: 'Help', icon: 'info', run: () => (dialog.value = 'about') },
];

/** One command for a value that a signal can have. */
function choice<T>(kind: string, value: T, title: string, of: Signal<T>): Command {
  return { id: `${kind}.${String(value)}`, title, group: 'View', checked: () => of.value === value, run: () => (of.value = value) };
}

export function registerPanelCommands(): void {
  register(...files, ...making, ...pictures, ...explore, ...layout, ...help);
}
