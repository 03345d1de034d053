import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { Connection, connect, send, type Wire } from '../../src/core/connection';
import { Drag } from '../../src/core/drag';
import { encodePack } from '../../src/core/packs';
import * as store from '../../src/core/store';
import { plan, shape, topology } from './fixtures';

/** A wire whose other end is the test. */
class FakeWire implements Wire {
  binaryType = '';
  onopen: (() => void) | null = null;
  onclose: (() => void) | null = null;
  onmessage: ((message: { data: unknown }) => void) | null = null;
  sent: Record<string, unknown>[] = [];
  send(text: string): void {
    this.sent.push(JSON.parse(text));
  }
  close(): void {
    this.onclose?.();
  }
  say(message: object): void {
    this.onmessage?.({ data: JSON.stringify(message) });
  }
  async answer(number = -1, more: object = {}): Promise<void> {
    this.say({ id: this.sent.at(number)?.id, ok: true, ...more });
    await Promise.resolve();
    await vi.advanceTimersByTimeAsync(0);
  }
}

let wires: FakeWire[] = [];
let frames: (() => void)[] = [];
let link: Connection;

function start(): FakeWire {
  link = new Connection(
    () => {
      const wire = new FakeWire();
      wires.push(wire);
      return wire;
    },
    (run) => frames.push(run),
  );
  connect(link);
  return wires[0];
}

async function open(): Promise<FakeWire> {
  const wire = start();
  wire.onopen?.();
  await wire.answer(-1, { version: '1' });
  return wire;
}

const { pack: _kind, positions, normals, edge_values, triangle_values, ...header } = shape();
function shapePack(sequence: number, height: number): ArrayBuffer {
  return encodePack({ ...header, pack: 'shape', sequence }, [
    { name: 'positions', data: positions.map((x, i) => (i === 14 ? height : x)), columns: 3 },
    { name: 'normals', data: normals, columns: 3 },
    { name: 'edge_values', data: edge_values },
    { name: 'triangle_values', data: triangle_values },
  ]);
}

function topologyPack(number = 7): ArrayBuffer {
  const { rods, ...rest } = topology();
  const arrays = Object.entries(rest).filter(([, v]) => ArrayBuffer.isView(v)) as [string, Float32Array][];
  const numbers = rods.map((rod, i) => ({ ...rod, plan_rod: i }));
  return encodePack({ pack: 'topology', sequence: 1, topology: number, plan_revision: 1, rods: numbers }, arrays.map(([name, data]) => ({ name, data })));
}

beforeEach(() => {
  vi.useFakeTimers();
  wires = [];
  frames = [];
  store.connection.value = 'connecting';
  store.topology.value = store.shape.value = store.plan.value = store.livePlan.value = null;
  store.picture.value = null;
  store.dragging.value = 0;
  store.fault.value = null;
});
afterEach(() => {
  link.end();
  vi.useRealTimers();
});

describe('connection', () => {
  test('says hello first and is open once that is answered', async () => {
    const wire = start();
    expect(store.connection.value).toBe('connecting');
    wire.onopen?.();
    expect(wire.sent[0]).toMatchObject({ do: 'hello', protocol: 1 });
    await wire.answer(-1, { version: '0.1' });
    expect(store.connection.value).toBe('open');
    expect(store.hello.value?.version).toBe('0.1');
  });

  test('answers go to their requests, in any order', async () => {
    const wire = await open();
    const first = send({ do: 'probe', x: 1 });
    const second = send({ do: 'probe', x: 2 });
    await wire.answer(-1, { x: 2 });
    await wire.answer(-2, { x: 1 });
    expect((await first).x).toBe(1);
    expect((await second).x).toBe(2);
  });

  test('a refusal is shown, unless asked to be quiet', async () => {
    const wire = await open();
    const error = { code: 'range', where: '/x', message: 'Too much.', hint: 'Less.' };
    const quiet = send({ do: 'undo' }, true);
    wire.say({ id: wire.sent.at(-1)?.id, ok: false, error });
    await quiet;
    expect(store.fault.value).toBeNull();
    const loud = send({ do: 'undo' });
    wire.say({ id: wire.sent.at(-1)?.id, ok: false, error });
    await loud;
    expect(store.fault.value).toEqual(error);
  });

  test('a lost wire answers what waits, is tried again, and says hello anew', async () => {
    const wire = await open();
    const waiting = send({ do: 'probe', x: 1 }, true);
    store.dragging.value = 3;
    wire.onclose?.();
    expect((await waiting).error?.code).toBe('lost');
    expect(store.connection.value).toBe('lost');
    expect(store.dragging.value).toBe(0);
    expect((await send({ do: 'undo' }, true)).ok).toBe(false);
    await vi.advanceTimersByTimeAsync(300);
    expect(wires).toHaveLength(2);
    wires[1].onclose?.();
    await vi.advanceTimersByTimeAsync(300);
    expect(wires).toHaveLength(2);
    await vi.advanceTimersByTimeAsync(300);
    expect(wires).toHaveLength(3);
    wires[2].onopen?.();
    await wires[2].answer();
    expect(store.connection.value).toBe('open');
  });

  test('a refused hello is shown and leaves the page closed', async () => {
    const wire = start();
    wire.onopen?.();
    wire.say({ id: wire.sent[0].id, ok: false, error: { code: 'version', where: '', message: 'Another protocol.', hint: '' } });
    await vi.advanceTimersByTimeAsync(0);
    expect(store.connection.value).toBe('connecting');
    expect(store.fault.value?.code).toBe('version');
  });

  test('of the shapes between two pictures only the newest is shown', async () => {
    const wire = await open();
    wire.say({ ...plan() });
    wire.onmessage?.({ data: topologyPack() });
    expect(store.topology.value?.rods.map((r) => r.plan_rod)).toEqual(['rim', 'cross']);
    wire.onmessage?.({ data: shapePack(2, 1) });
    wire.onmessage?.({ data: shapePack(3, 2) });
    wire.onmessage?.({ data: shapePack(4, 3) });
    expect(store.shape.value).toBeNull();
    expect(frames).toHaveLength(1);
    frames[0]();
    expect(store.shape.value?.sequence).toBe(4);
    expect(store.shape.value?.positions[14]).toBe(3);
    expect(store.rodRange.value).toMatchObject({ low: -2, high: 2 });
    expect(store.fabricRange.value.high).toBeCloseTo(1.4);
  });

  test('a shape of another mesh is not shown, and nodes of the old mesh are not selected any more', async () => {
    const wire = await open();
    wire.say({ ...plan() });
    wire.onmessage?.({ data: topologyPack() });
    store.selection.value = { points: new Set(['a', 'gone']), rods: new Set(), nodes: new Set([1]) };
    wire.onmessage?.({ data: topologyPack(8) });
    expect(store.selection.value.nodes.size).toBe(0);
    wire.onmessage?.({ data: shapePack(5, 1) });
    frames.forEach((run) => run());
    expect(store.picture.value).toBeNull();
    wire.say({ ...plan(), revision: 2 });
    expect([...store.selection.value.points]).toEqual(['a']);
  });

  test('what stood before a step is what stood before its drag', async () => {
    const wire = await open();
    wire.say({ ...plan() });
    wire.say({ event: 'history', steps: [], at: 0, saved_at: 0 });
    wire.onmessage?.({ data: topologyPack() });
    wire.onmessage?.({ data: shapePack(2, 1) });
    frames.splice(0).forEach((run) => run());
    const drag = new Drag();
    drag.update({ name: 'set_title', title: 'x' });
    wire.onmessage?.({ data: shapePack(3, 2) });
    frames.splice(0).forEach((run) => run());
    await wire.answer();
    drag.update({ name: 'set_title', title: 'y' });
    wire.onmessage?.({ data: shapePack(4, 3) });
    frames.splice(0).forEach((run) => run());
    wire.say({ event: 'history', steps: [{ title: 'x', seconds: 1 }], at: 1, saved_at: 0 });
    expect(store.shape.value?.sequence).toBe(4);
    expect(store.previousShape.value?.sequence).toBe(2);
    expect(store.previousMesh.value?.topology).toBe(7);
  });

  test('counts designs, not names', async () => {
    const wire = await open();
    const before = store.design.value;
    wire.say({ ...plan() });
    expect(store.design.value).toBe(before + 1);
    const edited = plan();
    edited.points[0].name = 'z';
    wire.say({ ...edited });
    expect(store.design.value).toBe(before + 1);
    const other = plan();
    other.points.forEach((p, i) => (p.name = `q${i}`));
    wire.say({ ...other });
    expect(store.design.value).toBe(before + 2);
  });

  test('a rod that is renamed keeps its mesh', async () => {
    const wire = await open();
    wire.say({ ...plan() });
    wire.onmessage?.({ data: topologyPack() });
    const other = plan();
    other.rods[1].name = 'spine';
    wire.say({ ...other });
    expect(store.topology.value?.rods[1].plan_rod).toBe('spine');
  });
});

describe('events of a drag', () => {
  test('views follow each plan, panels a few a second, and the last one arrives', async () => {
    const wire = await open();
    store.dragging.value = 5;
    for (let revision = 2; revision < 12; ++revision) wire.say({ ...plan(), revision });
    expect(store.livePlan.value?.revision).toBe(11);
    expect(store.plan.value?.revision ?? 0).toBeLessThan(11);
    await vi.advanceTimersByTimeAsync(250);
    expect(store.plan.value?.revision).toBe(11);
    store.dragging.value = 0;
    wire.say({ ...plan(), revision: 12 });
    expect(store.plan.value?.revision).toBe(12);
  });

  test('what is only looked at has no plan', async () => {
    const wire = await open();
    wire.say({ ...plan() });
    wire.say({ event: 'project', name: 'car', file: '', title: '', saved: true, kind: 'structure' });
    expect(store.plan.value).toBeNull();
    expect(store.livePlan.value).toBeNull();
  });
});

describe('drags', () => {
  const move = (x: number) => ({ name: 'move_points' as const, moves: [{ point: 'a', to_mm: [x, 0] as [number, number] }] });
  const drags = (wire: FakeWire) => wire.sent.filter((m) => String(m.do).startsWith('drag'));

  test('at most one is in flight, and the newest follows', async () => {
    const wire = await open();
    const drag = new Drag();
    drag.update(move(1));
    drag.update(move(2));
    drag.update(move(3));
    expect(drags(wire)).toHaveLength(1);
    expect(store.dragging.value).toBe(drag.number);
    await wire.answer();
    expect(drags(wire)).toHaveLength(2);
    expect(drags(wire)[1].edit).toEqual(move(3));
    const ended = drag.end();
    expect(drags(wire).at(-1)).toMatchObject({ do: 'drag_end', drag: drag.number, edit: move(3) });
    await wire.answer();
    expect((await ended)?.ok).toBe(true);
    expect(store.dragging.value).toBe(0);
  });

  test('a drag that never moved changes nothing, one that is cancelled says so', async () => {
    const wire = await open();
    expect(await new Drag().end()).toBeNull();
    const drag = new Drag();
    drag.update(move(1));
    drag.cancel();
    drag.update(move(2));
    expect(drags(wire).map((m) => m.do)).toEqual(['drag', 'drag_cancel']);
  });
});
