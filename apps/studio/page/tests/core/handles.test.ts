import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { Connection, connect, type Wire } from '../../src/core/connection';
import { holdInShape } from '../../src/core/handle_session';
import { acceptHandle, cancelHandle, gizmoPlace, moveHandle, resetPose, setSoftRadius } from '../../src/core/handles';
import { restPose } from '../../src/core/gizmo';
import { emptySelection, makeSelection } from '../../src/core/selection';
import * as store from '../../src/core/store';
import { nodesOf, toggleStill } from '../../src/core/still';
import { plan, shape, topology } from './fixtures';

interface Sent {
  id: number;
  do: string;
  [field: string]: unknown;
}

let sent: Sent[] = [];
let say: (message: object) => void = () => {};
let link: Connection;
let end = () => {};

const of = (what: string) => sent.filter((m) => m.do === what);
const rest = (milliseconds = 0) => vi.advanceTimersByTimeAsync(milliseconds);
async function answer(what: string, more: object = {}): Promise<void> {
  say({ id: of(what).at(-1)?.id, ok: true, ...more });
  await rest();
}

beforeEach(async () => {
  vi.useFakeTimers();
  sent = [];
  const wire: Wire = { binaryType: '', onopen: null, onclose: null, onmessage: null, send: (text) => sent.push(JSON.parse(text)), close: () => {} };
  say = (message) => wire.onmessage?.({ data: JSON.stringify(message) });
  store.handle.value = store.project.value = store.settledShape.value = store.handleCenter.value = null;
  store.jobs.value = {};
  store.selection.value = emptySelection;
  store.workMode.value = 'draw';
  link = new Connection(() => wire, (run) => run());
  connect(link);
  wire.onopen?.();
  await answer('hello');
  end = holdInShape();
});
afterEach(() => {
  end();
  link.end();
  vi.useRealTimers();
});

async function hold(): Promise<void> {
  store.workMode.value = 'shape';
  store.selection.value = makeSelection({ nodes: [4, 5] });
  await rest(100);
  await answer('handle_begin', { center_mm: [1, 2, 3], weights: 9, parameters: 12 });
}

describe('what is selected in Shape is held', () => {
  test('from the moment it is selected, with nodes before points', async () => {
    store.selection.value = makeSelection({ points: ['a'] });
    await rest(100);
    expect(of('handle_begin')).toHaveLength(0);
    await hold();
    expect(of('handle_begin').at(-1)).toMatchObject({ nodes: [4, 5], radius_mm: store.softRadius.value });
    expect(gizmoPlace()).toEqual([1, 2, 3]);
  });

  test('one request for many changes of the selection', async () => {
    store.workMode.value = 'shape';
    for (let i = 0; i < 5; ++i) store.selection.value = makeSelection({ points: ['a', String(i)] });
    await rest(100);
    expect(of('handle_begin')).toHaveLength(1);
    expect(of('handle_begin')[0].points).toEqual(['a', '4']);
  });

  test('an answer that comes after the next selection counts no more', async () => {
    store.workMode.value = 'shape';
    store.selection.value = makeSelection({ nodes: [1] });
    await rest(100);
    store.selection.value = makeSelection({ nodes: [2] });
    await rest(100);
    say({ id: of('handle_begin')[0].id, ok: true, center_mm: [9, 9, 9] });
    await rest();
    expect(store.handleCenter.value).toBeNull();
    await answer('handle_begin', { center_mm: [2, 2, 2] });
    expect(store.handleCenter.value).toEqual([2, 2, 2]);
  });

  test('and let go with the mode, with the selection, or when the engine lets go', async () => {
    await hold();
    store.workMode.value = 'draw';
    expect(store.handleCenter.value).toBeNull();
    expect(of('handle_cancel')).toHaveLength(1);
    await hold();
    say({ event: 'handle', active: true, center_mm: [1, 2, 3], radius_mm: 20, stale: false, sentence: '' });
    store.selection.value = emptySelection;
    await rest(100);
    expect(of('handle_cancel')).toHaveLength(2);
    await hold();
    say({ event: 'handle', active: false, center_mm: [0, 0, 0], radius_mm: 0, stale: false, sentence: '' });
    expect(store.handleCenter.value).toBeNull();
  });

  test('it is held again once the design is another one, but not while it is being fitted', async () => {
    await hold();
    const before = of('handle_begin').length;
    store.jobs.value = { fit: { event: 'job', job: 'fit', state: 'running', fraction: 0, iteration: 1, value: 1, unit: 'mm', detail: '' } };
    store.settledShape.value = { ...shape(), plan_revision: 5 };
    await rest(100);
    expect(of('handle_begin')).toHaveLength(before);
    store.jobs.value = {};
    await rest(100);
    expect(of('handle_begin')).toHaveLength(before + 1);
  });
});

describe('what is to stay', () => {
  test('goes with what is pulled, until it is let go or the design is another one', async () => {
    store.topology.value = topology();
    store.workMode.value = 'shape';
    store.selection.value = makeSelection({ nodes: [2, 3] });
    toggleStill();
    expect(store.selection.value.nodes.size).toBe(0);
    store.selection.value = makeSelection({ nodes: [3, 4] });
    await rest(100);
    expect(of('handle_begin').at(-1)).toMatchObject({ nodes: [3, 4], held: [2] });
    store.selection.value = makeSelection({ nodes: [2] });
    toggleStill();
    expect([...store.still.value.nodes]).toEqual([3]);
    store.design.value += 1;
    expect(store.still.value.nodes.size).toBe(0);
  });

  test('of a rod all nodes, of a point its own', () => {
    const mesh = topology();
    const [name] = mesh.rods.map((rod) => String(rod.plan_rod));
    const nodes = [...mesh.rod_nodes.subarray(mesh.rod_starts[0], mesh.rod_starts[1])];
    expect(new Set(nodesOf(makeSelection({ rods: [name] }), mesh))).toEqual(new Set(nodes));
    store.plan.value = plan();
    expect([...nodesOf(makeSelection({ points: [plan().points[0].name] }), mesh)]).toEqual([mesh.point_nodes[0]]);
  });
});

describe('moves of the handle', () => {
  test('at most one is in flight, the newest follows', async () => {
    await hold();
    const to = (x: number) => ({ ...restPose, move_mm: [x, 0, 0] as [number, number, number] });
    moveHandle(to(1));
    moveHandle(to(2));
    moveHandle(to(3));
    expect(of('handle_move')).toHaveLength(1);
    await answer('handle_move');
    expect(of('handle_move')).toHaveLength(2);
    expect(of('handle_move')[1].move_mm).toEqual([3, 0, 0]);
    expect(gizmoPlace()).toEqual([4, 2, 3]);
    await answer('handle_move');
    resetPose();
    expect(of('handle_move')[2].move_mm).toEqual([0, 0, 0]);
    await answer('handle_move');
  });

  test('radius, accept and cancel', async () => {
    setSoftRadius(12);
    expect(of('handle_radius')).toHaveLength(0);
    acceptHandle();
    expect(of('handle_accept')).toHaveLength(0);
    await hold();
    setSoftRadius(30);
    expect(of('handle_radius')[0].radius_mm).toBe(30);
    acceptHandle();
    expect(of('handle_accept')).toHaveLength(1);
    cancelHandle();
    expect(store.handleCenter.value).toBeNull();
    expect(of('handle_cancel')).toHaveLength(1);
    expect(store.selection.value.nodes.size).toBe(2);
  });
});
