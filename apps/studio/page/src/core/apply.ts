// Writes what the engine says into the store.

import { batch } from '@preact/signals-core';
import { CalmWriter } from './calm';
import { fitRanges } from './fields';
import type { EngineEvent, FieldInfo, Pack, PlanEvent, Request, ShapePack, TopologyPack } from './protocol';
import * as store from './store';

const kLogLines = 200;

const dragged = () => store.dragging.peek() !== 0;
const calmPlan = new CalmWriter(store.plan, dragged);
const calmVerdict = new CalmWriter(store.verdict, dragged);
const calmMeasures = new CalmWriter(store.measures, dragged);
const calmWarnings = new CalmWriter(store.warnings, dragged);

export function applyEvent(event: EngineEvent): void {
  switch (event.event) {
    case 'project':
      batch(() => {
        store.project.value = event;
        // What is only looked at has no plan: the one before must not stay.
        if (event.kind === 'plan') return;
        calmPlan.write(null);
        calmPlan.flush();
        // Nothing is solved for it either.
        for (const calm of [calmVerdict, calmMeasures]) {
          calm.write(null);
          calm.flush();
        }
        calmWarnings.write([]);
        calmWarnings.flush();
        store.livePlan.value = null;
        store.design.value += 1;
        if (event.kind === 'none') forgetShape();
      });
      break;
    case 'plan':
      batch(() => {
        if (!sameDesign(store.livePlan.peek(), event)) store.design.value += 1;
        store.livePlan.value = event;
        calmPlan.write(event);
        renameRods();
        dropVanished();
      });
      break;
    case 'history':
      if (event.at !== store.history.peek()?.at) keepPrevious();
      store.history.value = event;
      break;
    case 'verdict':
      calmVerdict.write(event);
      break;
    case 'measures':
      calmMeasures.write(event);
      break;
    case 'warnings':
      calmWarnings.write(event.warnings);
      break;
    case 'job':
      store.jobs.value = { ...store.jobs.peek(), [event.job]: event };
      break;
    case 'modes':
      store.modes.value = event;
      break;
    case 'handle':
      store.handle.value = event;
      if (!event.active) store.preview.value = null;
      break;
    case 'fit':
      store.fit.value = event;
      break;
    case 'branches':
      store.branches.value = event;
      break;
    case 'log':
      store.log.value = [...store.log.peek().slice(1 - kLogLines), event.text];
      break;
    case 'failed':
      store.fault.value = event.error;
      break;
  }
}

export function applyPack(pack: Pack): void {
  switch (pack.pack) {
    case 'topology':
      applyTopology(pack);
      break;
    case 'shape':
      applyShape(pack);
      break;
    case 'flat':
      store.flatShape.value = pack;
      break;
    case 'preview':
      store.preview.value = pack;
      break;
    case 'modes':
      store.modeShapes.value = pack;
      break;
    case 'branches':
      store.branchShapes.value = pack;
      break;
  }
}

/** One step of history leaves most points their names; another design has few of them, or none. */
function sameDesign(before: PlanEvent | null, now: PlanEvent): boolean {
  if (!before) return false;
  const names = new Set(before.points.map((p) => p.name));
  const kept = now.points.filter((p) => names.has(p.name)).length;
  return 2 * kept >= Math.min(before.points.length, now.points.length);
}

function keepPrevious(): void {
  batch(() => {
    store.previousMesh.value = before?.mesh ?? null;
    store.previousShape.value = before?.shape ?? null;
  });
}

/** What stood when the last change of the design was asked for. */
let before: { mesh: TopologyPack | null; shape: ShapePack | null; drag: number } | null = null;

const kChanges = new Set<Request['do']>(['edit', 'drag', 'undo', 'redo', 'go_to', 'mode_adopt', 'handle_accept', 'branch_take', 'remedy']);

/** Remembers the settled shape before a request changes it. Shapes come while a drag goes on and before the history says
 *  that there is a step: what stood before has to be kept when the change begins. */
export function rememberBefore(request: Request): void {
  if (!kChanges.has(request.do)) return;
  const drag = request.do === 'drag' ? request.drag : 0;
  if (drag !== 0 && drag === before?.drag) return;
  before = { mesh: store.settledMesh.peek(), shape: store.settledShape.peek(), drag };
}

/** Forgets mesh and shape: another engine counts its meshes anew. */
export function forgetShape(): void {
  batch(() => {
    store.topology.value = store.shape.value = store.settledShape.value = store.picture.value = null;
    store.settledMesh.value = store.previousMesh.value = null;
    store.flatShape.value = store.previousShape.value = store.preview.value = null;
    store.modeShapes.value = store.branchShapes.value = null;
  });
}

/** Numbers of the plan's rods, as the engine sent them with the present mesh, and how many rods there were. */
let planRods: { numbers: number[]; count: number } = { numbers: [], count: 0 };

function applyTopology(pack: TopologyPack): void {
  batch(() => {
    if (pack.topology !== store.topology.peek()?.topology) {
      // Numbers of nodes mean nothing on another mesh.
      const { points, rods } = store.selection.peek();
      if (store.selection.peek().nodes.size > 0) store.selection.value = { points, rods, nodes: new Set() };
      if (store.still.peek().nodes.size > 0) store.still.value = { ...store.still.peek(), nodes: new Set() };
      store.preview.value = null;
      store.modeShapes.value = null;
      store.branchShapes.value = null;
    }
    planRods = { numbers: pack.rods.map((rod) => Number(rod.plan_rod)), count: store.plan.peek()?.rods.length ?? 0 };
    store.topology.value = { ...pack, rods: namedRods(pack) };
  });
}

/** Rods of the mesh with the names of the plan's rods in the place of their numbers; others keep their own. */
function namedRods(pack: TopologyPack): TopologyPack['rods'] {
  const rods = store.plan.peek()?.rods ?? [];
  return pack.rods.map((rod, i) => ({ ...rod, plan_rod: rods[planRods.numbers[i]]?.name ?? rod.name }));
}

/** A rod of the plan may get another name while the mesh stays. */
function renameRods(): void {
  const topology = store.topology.peek();
  if (!topology || store.plan.peek()?.rods.length !== planRods.count) return;
  const rods = namedRods(topology);
  if (rods.every((rod, i) => rod.plan_rod === topology.rods[i].plan_rod)) return;
  const renamed = { ...topology, rods };
  store.topology.value = renamed;
  const shown = store.picture.peek();
  if (shown?.topology.topology === renamed.topology) store.picture.value = { ...shown, topology: renamed };
}

const kNoField: FieldInfo = { name: '', unit: '', low: 0, high: 1, diverging: false };

function applyShape(pack: ShapePack): void {
  const topology = store.topology.peek();
  if (!topology || pack.topology !== topology.topology) return;
  // Without a field the engine says nothing about one.
  pack.field_rods ??= kNoField;
  pack.field_fabric ??= kNoField;
  batch(() => {
    fitRanges(pack);
    // Another page may have asked for other fields.
    store.rodField.value = pack.field_rods.name;
    store.fabricField.value = pack.field_fabric.name;
    store.shape.value = pack;
    store.picture.value = { topology, shape: pack };
    if (!pack.settled) return;
    store.settledShape.value = pack;
    store.settledMesh.value = topology;
  });
}

/** Names that a new plan no longer has leave the selection. */
function dropVanished(): void {
  const now = store.selection.peek();
  const points = [...now.points].filter((name) => store.pointIndex.value.has(name));
  const rods = [...now.rods].filter((name) => store.rodIndex.value.has(name));
  if (points.length < now.points.size || rods.length < now.rods.size) {
    store.selection.value = { points: new Set(points), rods: new Set(rods), nodes: now.nodes };
  }
}
