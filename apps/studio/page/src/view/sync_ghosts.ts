// Second shapes over the first: flat, previous, the linear preview, the breathing mode, another branch.

import { effect } from '@preact/signals-core';
import type { TopologyPack } from '../core/protocol';
import * as store from '../core/store';
import type { GhostName, View } from './view';

/** One breath of a mode, ms. */
const kBreathMs = 2400;

export function syncGhosts(view: View): () => void {
  const put = (name: GhostName, topology: TopologyPack | null, positions: Float32Array | null) => {
    if (topology && positions) view.ghosts[name].show(topology, positions);
    else view.ghosts[name].hide();
    view.invalidate();
  };
  const ofPack = (name: GhostName, shown: () => boolean, pack: () => { topology: number; positions: Float32Array } | null) =>
    effect(() => {
      const topology = store.picture.value?.topology ?? null;
      const found = shown() ? pack() : null;
      put(name, topology, found && found.topology === topology?.topology ? found.positions : null);
    });
  const ends = [
    ofPack('flat', () => store.show.flat.value, () => store.flatShape.value),
    effect(() => {
      // The step may have brought another mesh: this shape is drawn with its own.
      const shown = store.show.previous.value;
      put('previous', store.previousMesh.value, shown ? (store.previousShape.value?.positions ?? null) : null);
    }),
    ofPack('preview', () => store.show.preview.value, () => (moves(store.preview.value?.positions) ? store.preview.value : null)),
    effect(() => {
      const topology = store.picture.value?.topology ?? null;
      const pack = store.branchShapes.value;
      const shown = store.shownBranch.value;
      const length = 3 * ((topology?.plan_places.length ?? 0) / 2);
      const fits = pack && shown >= 0 && pack.topology === topology?.topology && (shown + 1) * length <= pack.positions.length;
      put('branch', topology, fits ? pack.positions.subarray(shown * length, (shown + 1) * length) : null);
    }),
    breathe(view),
  ];
  return () => ends.forEach((end) => end());
}

/** Less than this is no other shape, mm. */
const kNothing = 0.02;

/** Whether places differ visibly from the shape's. */
function moves(positions: Float32Array | undefined): boolean {
  const now = store.shape.peek()?.positions;
  if (!positions || !now || now.length !== positions.length) return false;
  for (let i = 0; i < now.length; ++i) if (Math.abs(now[i] - positions[i]) > kNothing) return true;
  return false;
}

/** The shown mode swings about the shape; with reduced motion, or when told so, it stands at its amplitude. */
function breathe(view: View): () => void {
  let asked = 0;
  let places = new Float32Array(0);
  const step = (now: number) => {
    asked = 0;
    const { topology = null, shape = null } = store.picture.peek() ?? {};
    const pack = store.modeShapes.peek();
    const mode = store.shownMode.peek();
    const length = shape?.positions.length ?? 0;
    const fits = topology && shape && pack && mode >= 0 && pack.topology === topology.topology && (mode + 1) * length <= pack.displacements.length;
    if (!fits) {
      view.ghosts.mode.hide();
      view.invalidate();
      return;
    }
    if (places.length !== length) places = new Float32Array(length);
    const moves = store.modeBreathes.peek() && !store.reducedMotion.peek();
    const s = store.modeAmplitude.peek() * (moves ? Math.sin((2 * Math.PI * now) / kBreathMs) : 1);
    const from = mode * length;
    for (let i = 0; i < length; ++i) places[i] = shape.positions[i] + s * pack.displacements[from + i];
    view.ghosts.mode.show(topology, places);
    view.invalidate();
    if (moves) asked = requestAnimationFrame(step);
  };
  const end = effect(() => {
    void [store.picture.value, store.modeShapes.value, store.shownMode.value];
    void [store.modeAmplitude.value, store.modeBreathes.value, store.reducedMotion.value];
    if (asked === 0) asked = requestAnimationFrame(step);
  });
  return () => {
    end();
    cancelAnimationFrame(asked);
  };
}
