// The flat plan as a component, at true size with rulers in mm. Panels place it once; it fills its container and follows
// its size.

import { effect, signal } from '@preact/signals-core';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import type { Screen } from '../core/camera';
import { noteEcho } from '../core/latency';
import { fitPlan } from '../core/plan_camera';
import * as store from '../core/store';
import { paintLive, paintStill } from './plan_paint';
import { kRuler, paintOver, paintRulerCursor, paintRulers } from './plan_paint_over';
import { listenPlan } from './plan_pointer';
import { planScene, stillParts, type PlanScene } from './plan_scene';
import './view.css';

export function PlanView({ children }: { children?: ComponentChildren }) {
  const still = useRef<HTMLCanvasElement>(null);
  const live = useRef<HTMLCanvasElement>(null);
  const surface = useRef<HTMLDivElement>(null);

  useEffect(() => {
    if (!still.current || !live.current || !surface.current) return;
    const size = signal<Screen>({ width: 0, height: 0 });
    const observer = new ResizeObserver(([entry]) => {
      size.value = { width: Math.round(entry.contentRect.width), height: Math.round(entry.contentRect.height) };
    });
    observer.observe(live.current);
    const ends = [paint(still.current, live.current, size), fits(size), listenPlan(surface.current, () => size.peek())];
    return () => {
      observer.disconnect();
      ends.forEach((end) => end());
    };
  }, []);

  return (
    <div class="plan-view">
      <canvas ref={still} aria-hidden="true" />
      <canvas ref={live} aria-hidden="true" />
      <div
        ref={surface}
        class="view-surface"
        role="application"
        aria-label="Flat plan. Select points and rods in the tree or by pointer; arrow keys move what is selected."
        tabIndex={0}
      />
      {children}
    </div>
  );
}

/** Draws before the next picture of the screen whenever something that it shows has changed. */
function paint(still: HTMLCanvasElement, live: HTMLCanvasElement, size: { value: Screen }): () => void {
  let asked = 0;
  let parts: unknown[] = [];
  /** The plan as it was when the drag began: what does not move stays as it was painted then. */
  let held: PlanScene['plan'] = null;
  const draw = () => {
    asked = 0;
    const { width, height } = size.value;
    if (width < 2 || height < 2) return;
    const scene = planScene({ width, height });
    held = scene.moves.size === 0 ? scene.plan : (held ?? scene.plan);
    const now = stillParts({ ...scene, plan: held });
    if (now.some((part, i) => part !== parts[i])) {
      parts = now;
      // What is painted rarely is painted by the processor itself where no graphics card would do it.
      const pen = penOf(still, width, height, { willReadFrequently: store.softwareRenderer.peek() });
      if (pen) {
        paintStill(pen, { ...scene, plan: held });
        paintRulers(pen, scene);
      }
    }
    const pen = penOf(live, width, height);
    if (!pen) return;
    pen.clearRect(0, 0, width, height);
    pen.save();
    pen.beginPath();
    pen.rect(kRuler + 1, kRuler + 1, width, height);
    pen.clip();
    paintLive(pen, scene);
    paintOver(pen, scene);
    pen.restore();
    paintRulerCursor(pen, scene);
    noteEcho(performance.now());
  };
  const end = effect(() => {
    planScene(size.value);
    if (asked === 0) asked = requestAnimationFrame(draw);
  });
  return () => {
    end();
    cancelAnimationFrame(asked);
  };
}

/** The pen of a canvas that has the size of its place on the page, in CSS pixels. */
function penOf(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
  settings: CanvasRenderingContext2DSettings = {},
): CanvasRenderingContext2D | null {
  const ratio = devicePixelRatio;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const pen = canvas.getContext('2d', settings);
  pen?.setTransform(ratio, 0, 0, ratio, 0, 0);
  return pen;
}

/** Each design is shown whole when it comes, and when its place on the page changes while nobody has moved it. */
function fits(size: { value: Screen }): () => void {
  let design = -1;
  let camera: unknown = null;
  let fittedSize: Screen | null = null;
  return effect(() => {
    const now = store.design.value;
    const plan = store.livePlan.value;
    const screen = size.value;
    const untouched = store.planCamera.peek() === camera;
    if (!plan || screen.width < 2 || (design === now && (!untouched || fittedSize === screen))) return;
    const places = [...plan.points.map((p) => p.at_mm), ...plan.rods.flatMap((r) => r.line_mm)];
    const fit = fitPlan(places, screen, kRuler);
    if (!fit) return;
    design = now;
    fittedSize = screen;
    camera = fit;
    store.planCamera.value = fit;
  });
}
