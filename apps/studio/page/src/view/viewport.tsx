// The 3D view as a component. Panels place it once; it fills its container (position: relative, any size) and follows
// its size. Children are laid over the picture (legend, mode strip).

import { effect } from '@preact/signals-core';
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { note, notePreview, noteShape } from '../core/latency';
import * as store from '../core/store';
import { frameShape } from './camera_motion';
import { currentView, setCurrentView } from './current';
import { label } from './local';
import { Overlay } from './overlay';
import { takeMachine } from './machine';
import { listen3d } from './pointer3d';
import { sync } from './sync';
import { highQuality, kLowQuality, View } from './view';
import { ViewCube } from './view_cube';
import './view.css';

export function Viewport({ children }: { children?: ComponentChildren }) {
  const holder = useRef<HTMLDivElement>(null);
  const surface = useRef<HTMLDivElement>(null);
  const [missing, setMissing] = useState(false);

  useLayoutEffect(() => {
    if (!holder.current || !surface.current) return;
    const machine = takeMachine();
    if (!machine) {
      setMissing(true);
      return;
    }
    const { canvas } = machine;
    store.rendererName.value = machine.name;
    store.softwareRenderer.value = machine.software;
    canvas.setAttribute('aria-hidden', 'true');
    holder.current.append(canvas);
    const view = new View(machine, machine.software ? kLowQuality : highQuality());
    setCurrentView(view);
    const ends = [follow(canvas), sync(view), listen3d(surface.current), frames(), watch(view)];
    return () => {
      ends.forEach((end) => end());
      view.dispose();
      canvas.remove();
      if (currentView() === view) setCurrentView(null);
    };
  }, []);

  return (
    <div class="viewport">
      <div ref={holder} class="view-canvas" />
      <div
        ref={surface}
        class="view-surface"
        role="application"
        aria-label="Shape in space. Arrow keys turn it, plus and minus zoom, F fits it."
        tabIndex={0}
        data-turns
      />
      <Overlay />
      <ViewCube />
      {missing && <p class="view-message">This browser offers no WebGL 2, which the 3D view needs. Plan and panels work without it.</p>}
      {children}
    </div>
  );
}

/** Keeps store.viewSize at the size of the canvas. */
function follow(canvas: HTMLCanvasElement): () => void {
  const observer = new ResizeObserver(([entry]) => {
    const { width, height } = entry.contentRect;
    store.viewSize.value = { width: Math.round(width), height: Math.round(height) };
  });
  observer.observe(canvas);
  return () => observer.disconnect();
}

/** The first shape of each design is shown whole. */
function frames(): () => void {
  let design = -1;
  let before: number | undefined;
  let waiting = false;
  return effect(() => {
    const topology = store.shape.value?.topology;
    if (design !== store.design.value) {
      // The shape that is there now is still that of the design before.
      design = store.design.value;
      before = topology;
      waiting = true;
    }
    if (!waiting || topology === undefined || topology === before || store.viewSize.value.width < 2) return;
    waiting = false;
    frameShape();
  });
}

/** Times of pictures, for tests and the about box. */
function watch(view: View): () => void {
  let drawn = store.shape.peek();
  let previewed = store.preview.peek();
  let first = true;
  view.onDrawn = () => {
    const now = performance.now();
    const shape = store.shape.peek();
    const preview = store.preview.peek();
    if (shape && first) {
      first = false;
      note('first picture', now);
    }
    if (shape && shape !== drawn) noteShape(now, shape.drag !== 0, shape.settled);
    if (preview && preview !== previewed) notePreview(now);
    drawn = shape;
    previewed = preview;
  };
  return () => {
    view.onDrawn = () => {};
    label.value = null;
  };
}
