// window.lissomTest: what end-to-end tests ask the page. It only reads, but for the camera, which tests set so that their
// pictures are the same every time.

import { Projector, type Camera } from './core/camera';
import { waitingRequests } from './core/connection';
import { gripLines, type Grip } from './core/gizmo';
import { gizmoPlace } from './core/handles';
import { clearLatencies, latencies, type LatencyKind } from './core/latency';
import * as store from './core/store';
import { cameraMoves, setCamera } from './view/camera_motion';
import { toPixel } from './core/plan_camera';
import { kNoNode, type Vec2 } from './core/protocol';
import { row3 } from './core/vec';

function counts() {
  const topology = store.topology.peek();
  const plan = store.plan.peek();
  return {
    points: plan?.points.length ?? 0,
    rods: plan?.rods.length ?? 0,
    nodes: (topology?.plan_places.length ?? 0) / 2,
    triangles: (topology?.triangles.length ?? 0) / 3,
    steps: store.history.peek()?.steps.length ?? 0,
    at: store.history.peek()?.at ?? 0,
    warnings: store.warnings.peek().length,
    modes: store.modes.peek()?.modes.length ?? 0,
    branches: store.branches.peek()?.branches.length ?? 0,
  };
}

function selection() {
  const { points, rods, nodes } = store.selection.peek();
  return { points: [...points], rods: [...rods], nodes: [...nodes] };
}

function busy(): string {
  if (store.connection.peek() !== 'open') return `connection ${store.connection.peek()}`;
  if (waitingRequests() > 0) return `${waitingRequests()} requests without an answer`;
  if (store.dragging.peek() !== 0) return 'a drag';
  const job = Object.values(store.jobs.peek()).find((j) => j.state === 'running');
  if (job) return `job ${job.job}`;
  if (cameraMoves()) return 'the camera moves';
  const { running, shape, plan, topology } = store;
  const kind = store.project.peek()?.kind;
  if (kind === 'none') return '';
  if (!shape.peek()) return 'no shape';
  const behind = (shape.peek()?.plan_revision ?? 0) < (plan.peek()?.revision ?? 0) || shape.peek()?.topology !== topology.peek()?.topology;
  if (kind === 'plan' && running.peek() && (behind || store.verdict.peek() === null)) return 'the shape is behind the plan';
  return '';
}

/** Resolves when nothing is under way any more; rejects with what still was. */
async function whenIdle(milliseconds = 20000): Promise<void> {
  const end = performance.now() + milliseconds;
  let quiet = 0;
  for (;;) {
    const what = busy();
    // Twice in a row: an answer and the shape that follows it are different messages.
    quiet = what === '' ? quiet + 1 : 0;
    if (quiet >= 3) return;
    if (performance.now() > end) throw new Error(`still under way: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 40));
  }
}

/** Where a place of the plan, mm, is on the page, CSS pixels: for the pointer of tests. */
function pixelInPlan(at: Vec2): Vec2 | null {
  const box = document.querySelector('.plan-view')?.getBoundingClientRect();
  if (!box) return null;
  const [x, y] = toPixel(store.planCamera.peek(), box, at);
  return [box.left + x, box.top + y];
}

/** Where a control point is on the page. */
function pixelOf(point: string, where: 'plan' | 'shape'): Vec2 | null {
  const index = store.pointIndex.peek().get(point);
  const plan = store.plan.peek();
  if (index === undefined || !plan) return null;
  if (where === 'plan') return pixelInPlan(plan.points[index].at_mm);
  const box = document.querySelector('.viewport')?.getBoundingClientRect();
  if (!box) return null;
  const picture = store.picture.peek();
  const node = picture?.topology.point_nodes[index] ?? kNoNode;
  if (node === kNoNode || !picture) return null;
  const at = new Projector(store.camera.peek(), store.viewSize.peek()).point(row3(picture.shape.positions, node));
  return at && [box.left + at[0], box.top + at[1]];
}

/** Where a grip of the handle is on the page: "x", "turn-z", "scale", ... */
function pixelOfGrip(grip: Grip): Vec2 | null {
  const center = gizmoPlace();
  const box = document.querySelector('.viewport')?.getBoundingClientRect();
  if (!center || !box) return null;
  const projector = new Projector(store.camera.peek(), store.viewSize.peek());
  const line = grip === 'screen' ? [center] : gripLines(projector, center).find((l) => l.grip === grip)?.line;
  const at = line && projector.point(line[line.length - 1]);
  return at ? [box.left + at[0], box.top + at[1]] : null;
}

export interface LissomTest {
  counts: typeof counts;
  selection: typeof selection;
  camera: () => Camera;
  setCamera: (camera: Camera) => void;
  verdict: () => unknown;
  plan: () => unknown;
  history: () => unknown;
  fit: () => unknown;
  fault: () => unknown;
  jobs: () => unknown;
  renderer: () => { name: string; software: boolean };
  latencies: () => Readonly<Record<LatencyKind, readonly number[]>>;
  clearLatencies: () => void;
  busy: () => string;
  whenIdle: typeof whenIdle;
  pixelInPlan: typeof pixelInPlan;
  pixelOf: typeof pixelOf;
  pixelOfGrip: typeof pixelOfGrip;
}

export function installTestHook(target: { lissomTest?: LissomTest }): void {
  target.lissomTest = {
    counts,
    selection,
    camera: () => store.camera.peek(),
    setCamera,
    verdict: () => store.verdict.peek(),
    plan: () => store.plan.peek(),
    history: () => store.history.peek(),
    fit: () => store.fit.peek(),
    fault: () => store.fault.peek(),
    jobs: () => store.jobs.peek(),
    renderer: () => ({ name: store.rendererName.peek(), software: store.softwareRenderer.peek() }),
    latencies,
    clearLatencies,
    busy,
    whenIdle,
    pixelInPlan,
    pixelOf,
    pixelOfGrip,
  };
}
