// Moves of the camera: at once while a button is held, eased over 200 ms when a command asks.

import { effect } from '@preact/signals-core';
import { about, eased, fitted, named, orbitAbout, pan, type Camera } from '../core/camera';
import { bounds, type Vec3 } from '../core/vec';
import { kNoNode } from '../core/protocol';
import type { NamedView } from '../core/store';
import * as store from '../core/store';

const kEaseMs = 200;
let running = 0;

/** Sets the camera and ends a motion under way. */
export function setCamera(camera: Camera): void {
  cancelAnimationFrame(running);
  running = 0;
  store.camera.value = camera;
}

export function easeTo(camera: Camera, milliseconds = kEaseMs): void {
  cancelAnimationFrame(running);
  if (store.reducedMotion.peek()) {
    setCamera(camera);
    return;
  }
  const from = store.camera.peek();
  const start = performance.now();
  const step = (now: number) => {
    const t = Math.max(0, now - start) / milliseconds;
    store.camera.value = eased(from, camera, t);
    running = t < 1 ? requestAnimationFrame(step) : 0;
  };
  running = requestAnimationFrame(step);
}

export function cameraMoves(): boolean {
  return running !== 0;
}

export function look(view: NamedView): void {
  easeTo(view === 'home' ? fit(named(store.camera.peek(), 'home'), everything()) : named(store.camera.peek(), view));
}

export function fitAll(): void {
  easeTo(fit(store.camera.peek(), everything()));
}

export function fitSelection(): void {
  easeTo(fit(store.camera.peek(), selectedPlaces() ?? everything()));
}

/** How far, and how long, a shape turns that is shown for the first time: so that people see that it is one in space. */
const kOpeningTurn = 0.4;
const kOpeningMs = 900;

/** The whole shape, turning a little; at once where motion is unwanted or nothing but the processor draws. */
export function frameShape(): void {
  const home = fit(named(store.camera.peek(), 'home'), everything());
  setCamera(home);
  if (store.reducedMotion.peek() || store.softwareRenderer.peek()) return;
  setCamera({ ...home, yaw: home.yaw + kOpeningTurn });
  easeTo(home, kOpeningMs);
}

export function setPivot(at: Vec3): void {
  easeTo(about(store.camera.peek(), at));
}

/** What the view turns about: the middle of the selection when there is one. */
export function selectionMiddle(): Vec3 | null {
  const places = selectedPlaces();
  const box = places && bounds(places);
  return box ? [0, 1, 2].map((k) => 0.5 * (box.low[k] + box.high[k])) as Vec3 : null;
}

function fit(camera: Camera, places: ArrayLike<number> | null): Camera {
  const box = places && bounds(places);
  if (!box) return camera;
  return fitted(camera, box.low, box.high, store.viewSize.peek());
}

function everything(): ArrayLike<number> | null {
  return store.picture.peek()?.shape.positions ?? null;
}

function selectedPlaces(): number[] | null {
  const picture = store.picture.peek();
  if (!picture) return null;
  const { topology, shape } = picture;
  const { points, rods, nodes } = store.selection.peek();
  const wanted = new Set(nodes);
  for (const name of points) {
    const node = topology.point_nodes[store.pointIndex.peek().get(name) ?? -1] ?? kNoNode;
    if (node !== kNoNode) wanted.add(node);
  }
  topology.rods.forEach((rod, r) => {
    if (!rods.has(rod.plan_rod)) return;
    for (let i = topology.rod_starts[r]; i < topology.rod_starts[r + 1]; ++i) wanted.add(topology.rod_nodes[i]);
  });
  if (wanted.size === 0) return null;
  return [...wanted].flatMap((node) => [...shape.positions.subarray(3 * node, 3 * node + 3)]);
}

/** Turns (or shifts) by pixels, as the arrow keys do. */
export function turnView(dx: number, dy: number, shift: boolean): void {
  const camera = store.camera.peek();
  const size = store.viewSize.peek();
  setCamera(shift ? pan(camera, dx, dy, size) : orbitAbout(camera, selectionMiddle() ?? camera.target, dx, dy, size));
}

/** Keeps the camera's projection as the switch says. */
export function followProjection(): () => void {
  return effect(() => {
    const orthographic = store.orthographic.value;
    const now = store.camera.peek();
    if (now.orthographic !== orthographic) store.camera.value = { ...now, orthographic };
  });
}
