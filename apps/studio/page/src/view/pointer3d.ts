// The pointer over the 3D view: navigation, the handle, clicks, boxes and lassos.

import { effect } from '@preact/signals-core';
import { orbitAbout, pan, Projector, zoom } from '../core/camera';
import { dragged, gripAt, pixelAt, type Grip } from '../core/gizmo';
import { gizmoPlace, moveHandle, setSoftRadius } from '../core/handles';
import { note } from '../core/latency';
import { motionOf, wheelMotion, type Motion } from '../core/navigation';
import { boxRegion, lassoRegion } from '../core/regions';
import { join, joinOf, makeSelection } from '../core/selection';
import type { HandleMove } from '../core/protocol';
import * as store from '../core/store';
import type { Vec2, Vec3 } from '../core/vec';
import { selectionMiddle, setCamera, setPivot } from './camera_motion';
import { hotGrip, label, marquee } from './local';
import { pick, pickRegion } from './pick3d';
import { endTyping } from './shape_keys';

const kClickReach = 4;

type Press =
  | { kind: 'navigate'; motion: Motion; pivot: Vec3 | null }
  | { kind: 'grip'; grip: Grip; from: HandleMove }
  | { kind: 'marquee'; path: Vec2[] };

/** Listens on an element over the canvas; the function that it returns ends it. */
export function listen3d(element: HTMLElement): () => void {
  const end = new AbortController();
  const options = { signal: end.signal };
  let press: Press | null = null;
  let start: Vec2 = [0, 0];
  let last: Vec2 = [0, 0];

  const place = (event: MouseEvent): Vec2 => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const projector = () => new Projector(store.camera.peek(), store.viewSize.peek());
  const grip = (at: Vec2) => {
    const center = store.workMode.peek() === 'shape' ? gizmoPlace() : null;
    return center ? gripAt(projector(), center, at) : null;
  };

  element.addEventListener('pointerdown', (event) => {
    start = last = place(event);
    element.setPointerCapture(event.pointerId);
    const motion = motionOf(store.navigation.peek(), event);
    const held = motion ? null : grip(start);
    if (motion) {
      press = { kind: 'navigate', motion, pivot: selectionMiddle() };
    } else if (event.button === 0 && held) {
      endTyping();
      press = { kind: 'grip', grip: held, from: store.handlePose.peek() };
    } else if (event.button === 0) {
      press = { kind: 'marquee', path: [start] };
    }
  }, options);

  element.addEventListener('pointermove', (event) => {
    const at = place(event);
    if (!press) {
      hoverAt(at, grip(at));
    } else if (press.kind === 'navigate') {
      navigate(press.motion, at[0] - last[0], at[1] - last[1], start, press.pivot);
    } else if (press.kind === 'grip') {
      const center = store.handleCenter.peek();
      if (center) moveHandle(dragged(press.grip, projector(), center, press.from, start, at));
      note('pointer echo', performance.now() - event.timeStamp);
    } else {
      press.path.push(at);
      const lasso = store.activeTool.peek() === 'lasso';
      const corners: Vec2[] = lasso ? [...press.path] : [start, [at[0], start[1]], at, [start[0], at[1]]];
      if (Math.hypot(at[0] - start[0], at[1] - start[1]) > kClickReach) marquee.value = { corners, touching: !lasso && at[0] < start[0] };
    }
    last = at;
  }, options);

  element.addEventListener('pointerup', (event) => {
    const done = press;
    press = null;
    if (done?.kind !== 'marquee') return;
    const at = place(event);
    const how = joinOf(event);
    const nodes = store.workMode.peek() === 'shape';
    if (marquee.peek()) {
      const region = store.activeTool.peek() === 'lasso' ? lassoRegion(done.path) : boxRegion(start, at);
      store.selection.value = join(store.selection.peek(), pickRegion(region, nodes), how);
      marquee.value = null;
    } else {
      store.selection.value = join(store.selection.peek(), pick(at, nodes)?.selection ?? makeSelection({}), how);
    }
  }, options);

  const leave = () => {
    press = null;
    marquee.value = null;
    store.hover.value = null;
    label.value = null;
  };
  element.addEventListener('pointercancel', leave, options);
  element.addEventListener('pointerleave', () => press === null && leave(), options);
  for (const native of ['contextmenu', 'dragstart']) element.addEventListener(native, (event) => event.preventDefault(), options);
  element.addEventListener('dblclick', (event) => {
    const hit = pick(place(event), true);
    if (hit) setPivot(hit.at);
  }, options);
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    wheel(event, place(event));
  }, { passive: false, signal: end.signal });
  // What the label spoke of is elsewhere once the camera has moved.
  const moved = effect(() => {
    void store.camera.value;
    label.value = null;
  });
  return () => {
    moved();
    end.abort();
  };
}

function navigate(motion: Motion, dx: number, dy: number, start: Vec2, pivot: Vec3 | null): void {
  const camera = store.camera.peek();
  const size = store.viewSize.peek();
  if (motion === 'orbit') setCamera(orbitAbout(camera, pivot ?? camera.target, dx, dy, size));
  if (motion === 'pan') setCamera(pan(camera, dx, dy, size));
  if (motion === 'zoom') setCamera(zoom(camera, Math.exp(dy * 0.008), start, size));
}

function wheel(event: WheelEvent, at: Vec2): void {
  const size = store.viewSize.peek();
  const center = store.workMode.peek() === 'shape' ? gizmoPlace() : null;
  const now = new Projector(store.camera.peek(), size);
  const middle = center && now.point(center);
  const pixels = center ? store.softRadius.peek() / pixelAt(now, center) : 0;
  if (middle && !event.ctrlKey && Math.hypot(at[0] - middle[0], at[1] - middle[1]) < Math.max(pixels, 24)) {
    const factor = Math.exp(-Math.sign(event.deltaY) * 0.1);
    setSoftRadius(Math.round(Math.min(Math.max(store.softRadius.peek() * factor, 1), 1000) * 10) / 10);
    return;
  }
  const { motion, dx, dy, factor } = wheelMotion(store.navigation.peek(), event);
  if (motion === 'zoom') setCamera(zoom(store.camera.peek(), factor, at, size));
  else navigate(motion, dx, dy, at, selectionMiddle());
}

function hoverAt(at: Vec2, grip: Grip | null): void {
  hotGrip.value = grip;
  const hit = grip ? null : pick(at, store.workMode.peek() === 'shape');
  const before = store.hover.peek();
  const same = before?.kind === hit?.hover.kind && before?.name === hit?.hover.name && before?.index === hit?.hover.index;
  if (!same) store.hover.value = hit?.hover ?? null;
  const text = hit?.hover.text ?? '';
  label.value = text === '' ? null : { at, text };
}
