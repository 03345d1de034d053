// Control points, pins, attachments, ghost rods, the wanted places of a handle.

import { effect } from '@preact/signals-core';
import { kNoNode, type TopologyPack } from '../core/protocol';
import { nodesOf } from '../core/still';
import * as store from '../core/store';
import { bounds, norm, row3, sub, type Vec3 } from '../core/vec';
import type { Marker } from './markers';
import type { Stroke } from './screen_lines';
import type { View } from './view';

export function syncConstraints(view: View): () => void {
  const ends = [
    effect(() => {
      const now = present();
      view.markers.points.set(now && store.show.points.value ? pointMarkers(view, now) : []);
      view.markers.pins.set(now && store.show.constraints.value ? pinMarkers(view, now) : []);
      view.markers.still.set(now && store.workMode.value === 'shape' ? stillMarkers(view, now) : []);
      view.lines.links.set(now && store.show.constraints.value ? linkStrokes(view, now) : []);
      view.lines.dashed.set(now && store.show.ghosts.value ? ghostStrokes(view, now) : []);
      view.invalidate();
    }),
    effect(() => {
      const preview = store.show.target.value ? store.preview.value : null;
      void store.dark.value;
      view.markers.targets.set(preview ? targetMarkers(view, preview.target) : []);
      view.invalidate();
    }),
  ];
  return () => ends.forEach((end) => end());
}

interface Present {
  topology: TopologyPack;
  positions: Float32Array;
}

function present(): Present | null {
  void store.dark.value;
  const { value } = store.picture;
  return value && { topology: value.topology, positions: value.shape.positions };
}

function placeOf(name: string, now: Present): Vec3 | null {
  const node = now.topology.point_nodes[store.pointIndex.value.get(name) ?? -1] ?? kNoNode;
  return node === kNoNode ? null : row3(now.positions, node);
}

function pointMarkers(view: View, now: Present): Marker[] {
  const { palette } = view;
  const { points, nodes } = store.selection.value;
  const hovered = store.hover.value?.kind === 'point' ? store.hover.value.name : '';
  const markers: Marker[] = [];
  for (const point of store.plan.value?.points ?? []) {
    const place = placeOf(point.name, now);
    if (!place) continue;
    const selected = points.has(point.name);
    const hot = point.name === hovered;
    const colour = hot ? palette.hover : selected ? palette.select : palette.rod;
    markers.push({ place, colour, size: hot || selected ? 10 : 6 });
  }
  for (const node of nodes) markers.push({ place: row3(now.positions, node), colour: palette.select, size: 6 });
  return markers;
}

function pinMarkers(view: View, now: Present): Marker[] {
  const pinned = store.plan.value?.constraints.pinned ?? [];
  return pinned.flatMap((name) => {
    const place = placeOf(name, now);
    return place ? [{ place, colour: view.palette.pin, size: 17 }] : [];
  });
}

function stillMarkers(view: View, { topology, positions }: Present): Marker[] {
  return [...nodesOf(store.still.value, topology)].map((node) => ({ place: row3(positions, node), colour: view.palette.pin, size: 9 }));
}

function linkStrokes(view: View, now: Present): Stroke[] {
  const attached = store.plan.value?.constraints.attached ?? [];
  return attached.flatMap(([a, b]) => {
    const from = placeOf(a, now);
    const to = placeOf(b, now);
    return from && to ? [{ from, to, colour: view.palette.link, width: 3 }] : [];
  });
}

/** Dashes along the ghost rods, of a length that goes with the size of the design. */
function ghostStrokes(view: View, { topology, positions }: Present): Stroke[] {
  const strokes: Stroke[] = [];
  const { ghost_starts: starts, ghost_nodes: nodes } = topology;
  const box = bounds(positions);
  const dash = box ? norm(sub(box.high, box.low)) / 90 : 1;
  for (let g = 0; g + 1 < starts.length; ++g) {
    let gone = 0;
    for (let i = starts[g] + 1; i < starts[g + 1]; ++i) {
      const from = row3(positions, nodes[i - 1]);
      const to = row3(positions, nodes[i]);
      gone += norm(sub(to, from));
      if (Math.floor(gone / dash) % 2 === 0) strokes.push({ from, to, colour: view.palette.ghost, width: 2 });
    }
  }
  return strokes;
}

function targetMarkers(view: View, target: Float32Array): Marker[] {
  const markers: Marker[] = [];
  for (let i = 0; i + 3 < target.length; i += 4) {
    const weight = target[i + 3];
    if (weight > 0.02) markers.push({ place: target.subarray(i, i + 3), colour: view.palette.preview, size: 2.5 + 3.5 * weight });
  }
  return markers;
}
