import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { Connection, connect, type Wire } from '../../src/core/connection';
import { pickPlan } from '../../src/core/plan_picking';
import { emptySelection, makeSelection, type Join } from '../../src/core/selection';
import { planMarquee, sketch } from '../../src/core/sketch';
import { snap } from '../../src/core/snapping';
import * as store from '../../src/core/store';
import { toolOf, tools } from '../../src/tools/index';
import { ringPoints } from '../../src/tools/ring';
import type { PlanPointer, Tool } from '../../src/tools/tool';
import { plan } from '../core/fixtures';

let edits: Record<string, unknown>[] = [];
let sent: Record<string, unknown>[] = [];
let link: Connection;

beforeEach(async () => {
  vi.useFakeTimers();
  sent = [];
  edits = [];
  const wire: Wire = { binaryType: '', onopen: null, onclose: null, onmessage: null, send: () => {}, close: () => {} };
  wire.send = (text) => {
    const message = JSON.parse(text);
    sent.push(message);
    if (message.edit) edits.push(message.edit);
    queueMicrotask(() => wire.onmessage?.({ data: JSON.stringify({ id: message.id, ok: true }) }));
  };
  link = new Connection(() => wire, (run) => run());
  connect(link);
  wire.onopen?.();
  await vi.advanceTimersByTimeAsync(0);
  store.plan.value = store.livePlan.value = plan();
  store.project.value = null;
  store.selection.value = emptySelection;
  store.localMoves.value = new Map();
});
afterEach(() => {
  link.end();
  vi.useRealTimers();
});

/** A pointer at a place of the plan, one millimetre being twenty pixels. */
function at(tool: Tool, x: number, y: number, more: { pressed?: boolean; join?: Join } = {}): PlanPointer {
  const now = store.plan.peek();
  const options = { ...store.snapping.peek(), grid: false };
  const found = snap({ at: [x, y], options, grid_mm: 5, reach_mm: 0.45, from: tool.from?.(), except: tool.except?.() }, now);
  const hit = now && pickPlan(now, [x, y], 0.45, 0.35, { points: true, rods: true }, store.localMoves.peek());
  return { at: [x, y], snap: found, hit, join: more.join ?? 'replace', pressed: more.pressed ?? false, pixel_mm: 0.05, time: 1 };
}

function click(tool: Tool, x: number, y: number, join?: Join): void {
  tool.move?.(at(tool, x, y, { join }));
  tool.down?.(at(tool, x, y, { pressed: true, join }));
  tool.up?.(at(tool, x, y, { join }));
}

const key = (tool: Tool, name: string, more = {}) => tool.key?.({ key: name, ctrlKey: false, metaKey: false, shiftKey: false, ...more } as KeyboardEvent);
const rest = () => vi.advanceTimersByTimeAsync(0);

test('every tool has a name of its own, help and modes', () => {
  expect(new Set(tools.map((t) => t.id)).size).toBe(tools.length);
  const keys = tools.flatMap((t) => t.keys);
  expect(new Set(keys).size).toBe(keys.length);
  for (const tool of tools) {
    expect(tool.help.length).toBeGreaterThan(10);
    expect(tool.modes.length).toBeGreaterThan(0);
  }
  expect(toolOf('unknown').id).toBe('select');
});

describe('select and move', () => {
  const tool = toolOf('select');

  test('click, Shift, Ctrl, click on nothing', () => {
    click(tool, 0.1, 0);
    expect([...store.selection.value.points]).toEqual(['a']);
    click(tool, 7, 0.1, 'add');
    expect([...store.selection.value.rods]).toEqual(['rim']);
    click(tool, 0.1, 0, 'remove');
    expect(store.selection.value.points.size).toBe(0);
    click(tool, 7, 2);
    expect(store.selection.value.rods.size).toBe(0);
    expect(edits).toHaveLength(0);
  });

  test('dragging a point is one drag with its end, drawn before it is answered', async () => {
    tool.down?.(at(tool, 5.1, 5, { pressed: true }));
    tool.move?.(at(tool, 6, 4, { pressed: true }));
    tool.move?.(at(tool, 7.13, 4.5, { pressed: true }));
    expect(store.localMoves.value.get('m')).toEqual([7.13, 4.5]);
    expect(sketch.value.texts[0].text).toMatch(/^2\.1\d mm/);
    await rest();
    tool.up?.(at(tool, 7.13, 4.5));
    await rest();
    expect(sent.map((m) => m.do)).toEqual(['hello', 'drag', 'drag', 'drag_end']);
    expect(edits.at(-1)).toEqual({ name: 'move_points', moves: [{ point: 'm', to_mm: [7.13, 4.5] }] });
    expect(store.localMoves.value.size).toBe(0);
  });

  test('dragging a rod moves its points', async () => {
    tool.down?.(at(tool, 2.5, 2.5, { pressed: true }));
    tool.move?.(at(tool, 20, 33, { pressed: true }));
    await rest();
    tool.up?.(at(tool, 20, 33));
    const { moves } = edits.at(-1) as { moves: { point: string }[] };
    expect(moves.map((m) => m.point).sort()).toEqual(['a', 'c', 'm']);
  });

  test('Escape gives a drag up, then the selection', async () => {
    tool.down?.(at(tool, 5, 5, { pressed: true }));
    tool.move?.(at(tool, 6, 4, { pressed: true }));
    expect(key(tool, 'Escape')).toBe(true);
    await rest();
    expect(sent.at(-1)?.do).toBe('drag_cancel');
    expect(store.localMoves.value.size).toBe(0);
    expect(key(tool, 'Escape')).toBe(true);
    expect(store.selection.value.points.size).toBe(0);
    expect(key(tool, 'Escape')).toBe(false);
  });

  test('a box takes what it says', () => {
    tool.down?.(at(tool, -1, -1, { pressed: true }));
    tool.move?.(at(tool, 7, 11, { pressed: true }));
    expect(planMarquee.value?.touching).toBe(false);
    tool.up?.(at(tool, 7, 11));
    expect([...store.selection.value.points].sort()).toEqual(['a', 'd', 'm']);
    expect(planMarquee.value).toBeNull();
  });

  test('arrow keys move what is selected, with Shift by a whole step of the grid', () => {
    expect(key(tool, 'ArrowUp')).toBe(false);
    store.selection.value = makeSelection({ points: ['m'] });
    expect(key(tool, 'ArrowUp')).toBe(true);
    key(tool, 'ArrowLeft', { shiftKey: true });
    expect(edits.map((e) => (e.moves as { to_mm: number[] }[])[0].to_mm)).toEqual([[5, 5.5], [0, 5]]);
  });
});

describe('drawing', () => {
  test('a rod: click, click, Enter; on points and rods it snaps', async () => {
    const tool = toolOf('rod');
    tool.start?.();
    click(tool, 0.1, 0.1);
    click(tool, 7.5, 7.4);
    click(tool, 30, 2);
    expect(sketch.value.texts[0]?.text ?? '').toMatch(/mm in all|mm$/);
    expect(key(tool, 'Enter')).toBe(true);
    const [made] = edits;
    expect(made).toMatchObject({ name: 'add_rod', curve: 'spline', role: 'rod', closed: false });
    const through = made.through as Record<string, unknown>[];
    expect(through[0]).toEqual({ point: 'a' });
    expect(through[1].rod).toBe('cross');
    expect(Object.keys(through[2])).toEqual(['at_mm']);
    await rest();
    expect(sketch.value.points).toHaveLength(0);
  });

  test('keys after Enter are not for the rod that is under way to the engine', async () => {
    const tool = toolOf('rod');
    tool.start?.();
    click(tool, 20, 20);
    click(tool, 30, 24);
    key(tool, 'Enter');
    expect(key(tool, 'Escape')).toBe(false);
    click(tool, 40, 24);
    await rest();
    expect(sketch.value.points).toEqual([[40, 24]]);
  });

  test('Escape takes back one click after the other, then leaves', () => {
    const tool = toolOf('rod');
    tool.start?.();
    click(tool, 20, 20);
    click(tool, 30, 24);
    expect(key(tool, 'Escape')).toBe(true);
    expect(sketch.value.points).toEqual([[20, 20]]);
    expect(key(tool, 'Escape')).toBe(true);
    expect(key(tool, 'Escape')).toBe(false);
    expect(key(tool, 'Enter')).toBe(false);
    expect(edits).toHaveLength(0);
  });

  test('a click on the first point closes; a double click ends', async () => {
    const tool = toolOf('ghost-rod');
    tool.start?.();
    for (const [x, y] of [[20, 20], [30, 20], [30, 33], [20.1, 20]]) click(tool, x, y);
    expect(edits[0]).toMatchObject({ closed: true, role: 'ghost' });
    expect(edits[0].through).toHaveLength(3);
    await rest();
    click(tool, 20, 20);
    click(tool, 30, 24);
    tool.double?.(at(tool, 30, 24));
    expect(edits[1]).toMatchObject({ closed: false, curve: 'straight' });
    tool.stop?.();
    expect(sketch.value.lines).toHaveLength(0);
  });

  test('a ring has its radius', () => {
    const tool = toolOf('ring');
    tool.start?.();
    tool.down?.(at(tool, 40, 40, { pressed: true }));
    tool.move?.(at(tool, 52, 40, { pressed: true }));
    expect(sketch.value.texts[0].text).toBe('radius 12.0 mm');
    tool.up?.(at(tool, 52, 40));
    const through = edits[0].through as { at_mm: [number, number] }[];
    expect(through).toHaveLength(8);
    for (const { at_mm } of through) expect(Math.hypot(at_mm[0] - 40, at_mm[1] - 40)).toBeCloseTo(12, 9);
    expect(ringPoints([0, 0], 1, 4)[1][1]).toBeCloseTo(1);
    tool.down?.(at(tool, 40, 40, { pressed: true }));
    expect(key(tool, 'Escape')).toBe(true);
    tool.up?.(at(tool, 60, 40));
    expect(edits).toHaveLength(1);
  });
});

describe('one click', () => {
  test.each([
    ['insert', [7, 0.1], { name: 'insert_point', rod: 'rim' }],
    ['kink', [5, 5], { name: 'set_split', points: ['m'], split: true }],
    ['ghost', [7, 0.1], { name: 'set_role', rods: ['rim'], role: 'ghost' }],
    ['erase', [7, 0.1], { name: 'remove', rods: ['rim'] }],
    ['erase', [10, 0], { name: 'remove', points: ['b'] }],
    ['cut', [5, 5], { name: 'split_rod', rod: 'cross', point: 'm' }],
    ['pin', [5, 5], { name: 'set_constraints', pinned: ['m'] }],
    ['hole', [7, 2], { name: 'add_hole', at_mm: [7, 2] }],
  ] as const)('%s at %j', (id, [x, y], edit) => {
    const tool = toolOf(id);
    tool.start?.();
    click(tool, x, y);
    expect(edits[0]).toMatchObject(edit);
    expect(store.toolHint.value).toBe(tool.help);
  });

  test('a cut beside points is one step', async () => {
    click(toolOf('cut'), 2, 2.1);
    await rest();
    expect(edits).toMatchObject([{ name: 'split_rod', rod: 'cross', at_mm: [2.05, 2.05] }]);
  });

  test('a cut at an end says why not', () => {
    const lonely = plan();
    lonely.rods = [lonely.rods[1]];
    store.plan.value = lonely;
    click(toolOf('cut'), 0, 0);
    expect(edits).toHaveLength(0);
    expect(store.fault.value?.message).toContain('point a');
    store.fault.value = null;
  });

  test('a hole is filled by a click on its mark', () => {
    const now = plan();
    now.fabric.holes_mm = [[7, 2]];
    store.plan.value = now;
    click(toolOf('hole'), 7.1, 2);
    expect(edits[0]).toEqual({ name: 'remove_hole', hole: 0 });
  });

  test('nothing is edited where one only looks', () => {
    store.project.value = { event: 'project', name: 'x', file: '', title: '', saved: true, kind: 'structure' };
    click(toolOf('erase'), 7, 0.1);
    click(toolOf('mirror'), 12, 0.1);
    expect(edits).toHaveLength(0);
  });
});

describe('several clicks', () => {
  test('merge: the first stays, Enter ends', () => {
    const tool = toolOf('merge');
    tool.start?.();
    click(tool, 0, 0);
    click(tool, 0, 0);
    click(tool, 10, 0);
    click(tool, 10, 10);
    expect(key(tool, 'Backspace')).toBe(true);
    expect(key(tool, 'Enter')).toBe(true);
    expect(edits).toEqual([{ name: 'merge_points', points: ['a', 'b'] }]);
    expect(key(tool, 'Enter')).toBe(false);
  });

  test('attach: two are enough', () => {
    const tool = toolOf('attach');
    tool.start?.();
    click(tool, 0, 0);
    click(tool, 10, 10);
    expect(edits[0]).toMatchObject({ name: 'set_constraints', attached: [['a', 'c']] });
  });

  test('mirror: the selected rods, across an upright or a level line', () => {
    const tool = toolOf('mirror');
    tool.start?.();
    store.selection.value = makeSelection({ rods: ['cross'] });
    click(tool, 12, 3);
    expect(key(tool, 'y')).toBe(true);
    expect(sketch.value.texts[0].text).toBe('y = 3.0 mm');
    click(tool, 12, 3);
    expect(key(tool, 'x')).toBe(true);
    expect(edits).toEqual([
      { name: 'mirror', rods: ['cross'], axis: 'x', at_mm: 12 },
      { name: 'mirror', rods: ['cross'], axis: 'y', at_mm: 3 },
    ]);
  });

  test('lasso: what lies inside', () => {
    const tool = toolOf('lasso');
    tool.down?.(at(tool, -1, -1, { pressed: true }));
    for (const [x, y] of [[12, -1], [12, 3], [-1, 12]]) tool.move?.(at(tool, x, y, { pressed: true }));
    tool.up?.(at(tool, -1, 11));
    expect([...store.selection.value.points].sort()).toEqual(['a', 'b', 'd', 'm']);
  });
});
