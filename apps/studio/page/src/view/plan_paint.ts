// Draws the plan: fabric, rods at their true width, ghosts dashed, control points, constraints.

import { css, type Colour } from '../core/colours';
import { lineOf, placeOf, type Moves } from '../core/echo';
import type { PlanEvent, PlanRod, Vec2 } from '../core/protocol';
import { niceStep } from '../core/scale_bar';
import type { PlanScene } from './plan_scene';

type Pen = CanvasRenderingContext2D;

/** The still layer: what the pointer does not touch now. */
export function paintStill(pen: Pen, scene: PlanScene): void {
  pen.clearRect(0, 0, scene.size.width, scene.size.height);
  pen.lineJoin = pen.lineCap = 'round';
  if (scene.grid) paintGrid(pen, scene);
  paintFabric(pen, scene);
  const { plan, moves } = scene;
  if (!plan) return;
  for (const rod of rodsOf(scene, plan)) if (!isMoved(plan, rod, moves)) paintRod(pen, scene, plan, rod, 'plain');
  if (scene.constraints) paintConstraints(pen, scene, plan, (name) => !moves.has(name));
  if (scene.points) plan.points.forEach((p, i) => !moves.has(p.name) && paintPoint(pen, scene, plan, i, 'plain'));
}

/** The live layer: what is dragged, hovered or selected. */
export function paintLive(pen: Pen, scene: PlanScene): void {
  pen.lineJoin = pen.lineCap = 'round';
  const { plan, moves, hover, selection } = scene;
  if (!plan) return;
  for (const rod of rodsOf(scene, plan)) {
    const look = hover?.kind === 'rod' && hover.name === rod.name ? 'hot' : selection.rods.has(rod.name) ? 'selected' : 'plain';
    if (look !== 'plain' || isMoved(plan, rod, moves)) paintRod(pen, scene, plan, rod, look);
  }
  if (scene.constraints && moves.size > 0) paintConstraints(pen, scene, plan, (name) => moves.has(name));
  if (!scene.points) return;
  plan.points.forEach(({ name }, i) => {
    const look = hover?.kind === 'point' && hover.name === name ? 'hot' : selection.points.has(name) ? 'selected' : 'plain';
    if (look !== 'plain' || moves.has(name)) paintPoint(pen, scene, plan, i, look);
  });
}

type Look = 'plain' | 'hot' | 'selected';

function rodsOf({ ghosts }: PlanScene, plan: PlanEvent): PlanRod[] {
  return ghosts ? plan.rods : plan.rods.filter((rod) => rod.role === 'rod');
}

function isMoved(plan: PlanEvent, rod: PlanRod, moves: Moves): boolean {
  return moves.size > 0 && rod.points.some((i) => moves.has(plan.points[i].name));
}

export function rgba(colour: Colour, alpha: number): string {
  return `rgb(${colour[0]} ${colour[1]} ${colour[2]} / ${alpha})`;
}

export function trace(pen: Pen, line: readonly Vec2[], pixel: (at: Vec2) => Vec2, closed = false): void {
  pen.beginPath();
  line.forEach((p, i) => {
    const [x, y] = pixel(p);
    if (i === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  });
  if (closed) pen.closePath();
}

function paintGrid(pen: Pen, { camera, size, palette, gridStep }: PlanScene): void {
  const step = Math.max(gridStep, niceStep(9 / camera.pixels_per_mm));
  const { center_mm: c, pixels_per_mm: s } = camera;
  const span: Vec2 = [size.width / s / 2, size.height / s / 2];
  pen.lineWidth = 1;
  for (let k = 0; k < 2; ++k) {
    for (let i = Math.ceil((c[k] - span[k]) / step); i * step <= c[k] + span[k]; ++i) {
      pen.strokeStyle = rgba(palette.grid, i === 0 ? 0.55 : i % 10 === 0 ? 0.3 : 0.13);
      const at = Math.round(k === 0 ? size.width / 2 + (i * step - c[0]) * s : size.height / 2 - (i * step - c[1]) * s) + 0.5;
      pen.beginPath();
      pen.moveTo(k === 0 ? at : 0, k === 0 ? 0 : at);
      pen.lineTo(k === 0 ? at : size.width, k === 0 ? size.height : at);
      pen.stroke();
    }
  }
}

/** The fabric as meshed, with its border; waits for the mesh while something is dragged. */
function paintFabric(pen: Pen, { topology, pixel, palette, plan }: PlanScene): void {
  if (!topology || topology.rim.length === 0) return;
  const { plan_places: places, rim } = topology;
  const at = (node: number): Vec2 => pixel([places[2 * node], places[2 * node + 1]]);
  pen.beginPath();
  for (const loop of loopsOf(rim)) {
    loop.forEach((node, i) => (i === 0 ? pen.moveTo(...at(node)) : pen.lineTo(...at(node))));
    pen.closePath();
  }
  pen.fillStyle = rgba(palette.fabric, 0.6);
  pen.fill('evenodd');
  pen.strokeStyle = rgba(palette.inkSoft, 0.5);
  pen.lineWidth = 1;
  pen.stroke();
  for (const hole of plan?.fabric.holes_mm ?? []) {
    const [x, y] = pixel(hole);
    pen.beginPath();
    pen.moveTo(x - 4, y - 4);
    pen.lineTo(x + 4, y + 4);
    pen.moveTo(x + 4, y - 4);
    pen.lineTo(x - 4, y + 4);
    pen.stroke();
  }
}

const loopsByRim = new WeakMap<Uint32Array, number[][]>();

/** Edges of a border, in any order, as closed loops of nodes. */
function loopsOf(rim: Uint32Array): number[][] {
  const known = loopsByRim.get(rim);
  if (known) return known;
  const next = new Map<number, number[]>();
  for (let i = 0; i < rim.length; i += 2) {
    for (const [a, b] of [[rim[i], rim[i + 1]], [rim[i + 1], rim[i]]]) next.set(a, [...(next.get(a) ?? []), b]);
  }
  const loops: number[][] = [];
  const done = new Set<number>();
  for (const start of next.keys()) {
    const loop: number[] = [];
    let node: number | undefined = start;
    while (node !== undefined && !done.has(node)) {
      done.add(node);
      loop.push(node);
      node = next.get(node)?.find((n) => !done.has(n));
    }
    if (loop.length > 2) loops.push(loop);
  }
  loopsByRim.set(rim, loops);
  return loops;
}

function paintRod(pen: Pen, scene: PlanScene, plan: PlanEvent, rod: PlanRod, look: Look): void {
  const { palette, camera, moves, pixel } = scene;
  const radius = rod.points.reduce((sum, i) => sum + plan.points[i].r_b_mm, 0) / Math.max(rod.points.length, 1);
  const width = Math.max(2 * radius * camera.pixels_per_mm, 1.75);
  const ghost = rod.role === 'ghost';
  trace(pen, lineOf(plan, rod, moves), pixel);
  if (look !== 'plain') {
    pen.lineWidth = (ghost ? 2 : width) + 5;
    pen.strokeStyle = rgba(look === 'hot' ? palette.hover : palette.select, 0.35);
    pen.stroke();
  }
  pen.setLineDash(ghost ? [6, 5] : []);
  pen.lineWidth = ghost ? 1.75 : width;
  const plain = ghost ? palette.ghost : palette.rod;
  pen.strokeStyle = css(look === 'hot' ? palette.hover : look === 'selected' ? palette.select : plain);
  pen.stroke();
  pen.setLineDash([]);
}

function paintPoint(pen: Pen, scene: PlanScene, plan: PlanEvent, index: number, look: Look): void {
  const { palette, selection, moves } = scene;
  const { name, split } = plan.points[index];
  const [x, y] = scene.pixel(placeOf(plan, index, moves));
  const selected = look !== 'plain' && selection.points.has(name);
  const r = look === 'plain' ? 3.5 : 5;
  pen.beginPath();
  // Kinks are square, smooth points round.
  if (split) pen.rect(x - r, y - r, 2 * r, 2 * r);
  else pen.arc(x, y, r, 0, 2 * Math.PI);
  pen.fillStyle = css(selected ? palette.select : look === 'hot' ? palette.hover : palette.ground);
  pen.fill();
  pen.lineWidth = 1.5;
  pen.strokeStyle = css(selected ? palette.select : palette.rod);
  pen.stroke();
}

function paintConstraints(pen: Pen, scene: PlanScene, plan: PlanEvent, shown: (name: string) => boolean): void {
  const { palette, moves, pixel, size } = scene;
  const at = (name: string): Vec2 | null => {
    const index = plan.points.findIndex((p) => p.name === name);
    return index < 0 ? null : pixel(placeOf(plan, index, moves));
  };
  pen.lineWidth = 2;
  pen.strokeStyle = pen.fillStyle = css(palette.pin);
  for (const name of plan.constraints.pinned.filter(shown)) {
    const p = at(name);
    if (!p) continue;
    pen.beginPath();
    pen.moveTo(p[0], p[1] + 4);
    pen.lineTo(p[0] - 6, p[1] + 14);
    pen.lineTo(p[0] + 6, p[1] + 14);
    pen.closePath();
    pen.fill();
  }
  for (const [a, b] of plan.constraints.attached) {
    if (!shown(a) && !shown(b)) continue;
    const [from, to] = [at(a), at(b)];
    if (from && to) trace(pen, [from, to], (p) => p);
    pen.stroke();
  }
  const { symmetric } = plan.constraints;
  if (!symmetric) return;
  pen.setLineDash([12, 4, 2, 4]);
  pen.lineWidth = 1;
  const [x, y] = pixel([symmetric.at_mm, symmetric.at_mm]);
  trace(pen, symmetric.axis === 'x' ? [[x, 0], [x, size.height]] : [[0, y], [size.width, y]], (p) => p);
  pen.stroke();
  pen.setLineDash([]);
}
