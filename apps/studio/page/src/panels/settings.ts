// What the browser keeps from one visit to the next: look, layout and keys. Nothing of the design.

import { effect, type Signal } from '@preact/signals';
import { keyOverrides } from '../core/commands';
import {
  dark,
  gridStep,
  inspectorOpen,
  navigation,
  planDock,
  quality,
  snapping,
  theme,
  treeOpen,
  uiScale,
} from '../core/store';
import { beganBefore, planShare } from './layout_state';

const kept: Readonly<Record<string, Signal<unknown>>> = {
  theme: theme as Signal<unknown>,
  scale: uiScale as Signal<unknown>,
  navigation: navigation as Signal<unknown>,
  quality: quality as Signal<unknown>,
  planDock: planDock as Signal<unknown>,
  planShare: planShare as Signal<unknown>,
  tree: treeOpen as Signal<unknown>,
  inspector: inspectorOpen as Signal<unknown>,
  snapping: snapping as Signal<unknown>,
  gridStep: gridStep as Signal<unknown>,
  keys: keyOverrides as Signal<unknown>,
  beganBefore: beganBefore as Signal<unknown>,
};

/** Takes over what was kept, then keeps every change. Called once, before the page is drawn. */
export function keepSettings(storage: Pick<Storage, 'getItem' | 'setItem'>): () => void {
  const ends = Object.entries(kept).map(([name, setting]) => {
    const text = storage.getItem(`lissom.${name}`);
    const value = text === null ? undefined : parsed(text);
    if (value !== undefined && typeof value === typeof setting.peek()) setting.value = value;
    return effect(() => storage.setItem(`lissom.${name}`, JSON.stringify(setting.value)));
  });
  ends.push(
    effect(() => {
      const root = document.documentElement;
      root.dataset.theme = dark.value ? 'dark' : 'light';
      root.dataset.scale = String(Math.round((100 * uiScale.value) / 25) * 25);
    }),
  );
  return () => ends.forEach((end) => end());
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}
