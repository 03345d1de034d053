// What the store says becomes what the view draws. One effect for each thing that changes by itself.

import { effect, signal } from '@preact/signals-core';
import { nodesOf, softWeights } from '../core/soft';
import type { FieldInfo, TopologyPack } from '../core/protocol';
import * as store from '../core/store';
import { followProjection } from './camera_motion';
import { syncConstraints } from './sync_constraints';
import { syncGhosts } from './sync_ghosts';
import { paletteOf } from './palette';
import { highQuality, kLowQuality, type View } from './view';

/** Fields are named by the engine; an empty name asks for none. */
function fieldOf(info: FieldInfo | undefined, name: string): FieldInfo | null {
  return name !== '' && info && info.name !== '' && info.name !== 'none' ? info : null;
}

/** Starts all effects; the function that it returns ends them. */
export function sync(view: View): () => void {
  /** The mesh that the view has: a new one is taken over with its first shape. */
  const shown = signal<TopologyPack | null>(null);
  const ends = [
    followProjection(),
    effect(() => view.setPalette(paletteOf(store.dark.value))),
    effect(() => view.setScreen(store.viewSize.value)),
    effect(() => {
      view.setCamera(store.camera.value);
      view.hurry();
    }),
    effect(() => {
      if (store.dragging.value === 0) view.hurry();
    }),
    effect(() => {
      const { value } = store.quality;
      const low = value === 'low' || (value === 'auto' && store.softwareRenderer.value);
      view.setQuality(low ? kLowQuality : highQuality());
    }),
    effect(() => {
      const { value } = store.picture;
      if (!value) {
        shown.value = null;
        return;
      }
      const { topology, shape } = value;
      if (shown.peek()?.topology !== topology.topology) view.setTopology(topology);
      shown.value = topology;
      view.hurry(store.dragging.peek() !== 0);
      view.setShape(shape, fieldOf(shape.field_rods, store.rodField.value) !== null, fieldOf(shape.field_fabric, store.fabricField.value) !== null);
    }),
    effect(() => {
      view.setColours('rods', fieldOf(store.shape.value?.field_rods, store.rodField.value), store.rodRange.value);
    }),
    effect(() => {
      view.setColours('fabric', fieldOf(store.shape.value?.field_fabric, store.fabricField.value), store.fabricRange.value);
    }),
    effect(() => view.setFaded(store.verdict.value?.shown === 'last good' ? 0.5 : 0)),
    effect(() => {
      const some = store.picture.value !== null;
      view.rods.mesh.visible = some && store.show.rods.value;
      view.fabric.mesh.visible = some && store.show.fabric.value;
      view.fabric.showLines(some && store.show.mesh.value);
      view.grid.lines.visible = store.show.grid.value;
      view.invalidate();
    }),
    effect(() => syncMarks(view, shown.value)),
    syncGhosts(view),
    syncConstraints(view),
  ];
  return () => ends.forEach((end) => end());
}

/** What is selected, hovered, softly selected or among the worst, on rods and fabric. */
function syncMarks(view: View, topology: TopologyPack | null): void {
  if (!topology) return;
  const { rods } = store.selection.value;
  const hovered = store.hover.value;
  const selected = nodesOf(store.selection.value, store.pointIndex.value, topology).filter((node) => 2 * node < topology.plan_places.length);
  // While something moves, the weights of a moment ago are good enough.
  const positions = store.picture.peek()?.shape.positions ?? null;
  const soft = store.workMode.value === 'shape' && selected.length > 0 && positions;
  const weights = soft ? softWeights(positions, selected, store.softRadius.value) : null;
  const isSelected = new Set(store.selection.value.nodes);
  const worst = new Set(store.verdict.value?.settled === false ? store.verdict.value.worst.map((w) => w.node) : []);
  view.rods.setMarks((_slot, rod, node) => {
    const plan = topology.rods[rod].plan_rod;
    return [
      rods.has(plan) || isSelected.has(node) ? 255 : 0,
      hovered?.kind === 'rod' && hovered.name === plan ? 255 : 0,
      weights ? Math.round(255 * weights[node]) : 0,
      worst.has(node) ? 255 : 0,
    ];
  });
  view.fabric.setWeights(weights);
  view.invalidate();
}
