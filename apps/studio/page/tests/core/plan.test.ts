import { describe, expect, test } from 'vitest';
import { attaching, ghosting, kinking, nudge, pinning, removal, rodThrough } from '../../src/core/edits';
import { lineOf } from '../../src/core/echo';
import { everything, grown, inverted, pointsOf, shrunk } from '../../src/core/growth';
import { fitPlan, panPlan, toPixel, toPlan, zoomPlan } from '../../src/core/plan_camera';
import { emptySelection, join, joinOf, makeSelection } from '../../src/core/selection';
import { middleOf, snap, type SnapRequest } from '../../src/core/snapping';
import { mirrored, withImages } from '../../src/core/symmetry';
import { plan, topology } from './fixtures';

const on = { grid: true, points: true, rods: true, angle: true, symmetry: true };
const request = (at: [number, number], more: Partial<SnapRequest> = {}): SnapRequest => ({ at, options: on, grid_mm: 5, reach_mm: 0.5, ...more });

describe('snapping', () => {
  test('to where a line from the point before touches a rod', () => {
    const now = plan();
    const turn = (i: number): [number, number] => [30 + 10 * Math.cos((i * Math.PI) / 32), 10 * Math.sin((i * Math.PI) / 32)];
    now.rods[1].line_mm = Array.from({ length: 33 }, (_, i) => turn(i));
    // From (30, 20) a circle of radius 10 about (30, 0) is touched at 30 degrees.
    const [x, y] = [30 + 10 * Math.cos(Math.PI / 6), 5];
    const found = snap(request([x + 0.4, y - 0.3], { from: [30, 20], options: { ...on, points: false } }), now);
    expect(found).toMatchObject({ kind: 'tangent', name: 'cross' });
    expect(Math.hypot(found.at[0] - x, found.at[1] - y)).toBeLessThan(1);
    expect(snap(request([30, 10.2], { from: [30, 20], options: { ...on, points: false } }), now).kind).not.toBe('tangent');
  });

  test('points, then middles, then rods', () => {
    expect(snap(request([10.2, 0.1]), plan())).toMatchObject({ kind: 'point', name: 'b', at: [10, 0] });
    expect(snap(request([9.9, 9.8], { except: new Set(['c']) }), plan()).kind).not.toBe('point');
    expect(snap(request([2, 2.1]), plan())).toMatchObject({ kind: 'rod', name: 'cross' });
    const noPoints = { ...on, points: false };
    expect(snap(request([5.1, 5], { options: noPoints }), plan())).toMatchObject({ kind: 'middle', at: [5, 5] });
  });

  test('the line of symmetry', () => {
    const mirror = plan();
    mirror.constraints.symmetric = { axis: 'x', at_mm: 20 };
    expect(snap(request([20.3, 7]), mirror)).toMatchObject({ kind: 'symmetry', at: [20, 7] });
    mirror.constraints.symmetric = { axis: 'y', at_mm: 20 };
    expect(snap(request([33, 19.8]), mirror)).toMatchObject({ kind: 'symmetry', at: [33, 20] });
  });

  test('steps of 15 degrees from the point before', () => {
    const found = snap(request([31, 31.1], { from: [21, 21], options: { ...on, grid: false } }), plan());
    expect(found.kind).toBe('angle');
    expect(found.name).toBe('45°');
    expect(found.at[0] - 21).toBeCloseTo(found.at[1] - 21, 9);
    expect(snap(request([21.2, 21.3], { from: [21, 21], options: { ...on, grid: false } }), plan()).kind).toBe('free');
  });

  test('the grid holds each coordinate by itself', () => {
    expect(snap(request([25.2, 31.7]), plan())).toMatchObject({ kind: 'grid', at: [25, 31.7] });
    expect(snap(request([22.3, 32.4]), plan()).kind).toBe('free');
  });

  test('Alt suspends, and so does having no plan', () => {
    expect(snap(request([10.2, 0.1], { suspended: true }), plan()).kind).toBe('free');
    expect(snap(request([10.2, 0.1]), null).kind).toBe('free');
  });

  test('the middle is half way along', () => {
    expect(middleOf([[0, 0], [4, 0], [4, 8]])).toEqual([4, 2]);
    expect(middleOf([[1, 1]])).toBeNull();
  });
});

describe('echo', () => {
  test('a rod bends with its points and stays elsewhere', () => {
    const now = plan();
    const cross = now.rods[1];
    expect(lineOf(now, cross, new Map())).toBe(cross.line_mm);
    expect(lineOf(now, cross, new Map([['b', [0, 0]]]))).toBe(cross.line_mm);
    expect(lineOf(now, cross, new Map([['c', [20, 10]]]))).toEqual([[0, 0], [5, 5], [20, 10]]);
  });

  test('a closed rod closes', () => {
    const now = plan();
    const line = lineOf(now, now.rods[0], new Map([['a', [-3, -3]]]));
    expect(line[0]).toEqual([-3, -3]);
    expect(line.at(-1)).toEqual([-3, -3]);
    expect(line[1]).toEqual([10, 0]);
  });

  test('samples between points move by the share of their way', () => {
    const now = plan();
    now.rods[1].line_mm = [[0, 0], [2.5, 2.5], [5, 5], [7.5, 7.5], [10, 10]];
    expect(lineOf(now, now.rods[1], new Map([['m', [5, 9]]]))).toEqual([[0, 0], [2.5, 4.5], [5, 9], [7.5, 9.5], [10, 10]]);
  });
});

describe('symmetric editing', () => {
  test('mirror images move too, points on the line stay on it', () => {
    const now = plan();
    now.constraints.symmetric = { axis: 'x', at_mm: 5 };
    expect(mirrored([1, 2], now.constraints.symmetric)).toEqual([9, 2]);
    expect(withImages(now, [{ point: 'a', to_mm: [-1, -2] }])).toEqual([
      { point: 'a', to_mm: [-1, -2] },
      { point: 'b', to_mm: [11, -2] },
    ]);
    expect(withImages(now, [{ point: 'm', to_mm: [6, 7] }])).toEqual([{ point: 'm', to_mm: [5, 7] }]);
    expect(withImages(now, [{ point: 'gone', to_mm: [6, 7] }])).toEqual([]);
    expect(withImages(now, [{ point: 'a', to_mm: [1, 1] }, { point: 'b', to_mm: [2, 2] }])).toHaveLength(2);
    expect(withImages(plan(), [{ point: 'a', to_mm: [1, 1] }])).toHaveLength(1);
  });
});

describe('selection', () => {
  test('Shift adds, Ctrl removes, neither replaces', () => {
    const a = makeSelection({ points: ['a'], rods: ['rim'] });
    const b = makeSelection({ points: ['b'], rods: ['rim'] });
    const keys = { shiftKey: false, ctrlKey: false, metaKey: false };
    expect([...join(a, b, joinOf(keys)).points]).toEqual(['b']);
    expect([...join(a, b, joinOf({ ...keys, shiftKey: true })).points]).toEqual(['a', 'b']);
    expect([...join(a, b, joinOf({ ...keys, metaKey: true })).rods]).toEqual([]);
  });

  test('grows and shrinks along rods', () => {
    const grew = grown(makeSelection({ points: ['m'], nodes: [4] }), plan(), topology());
    expect([...grew.points].sort()).toEqual(['a', 'c', 'm']);
    expect([...grew.nodes].sort()).toEqual([0, 2, 4]);
    expect([...shrunk(grew, plan(), topology()).points]).toEqual(['m']);
    expect([...shrunk(grew, plan(), topology()).nodes]).toEqual([4]);
    expect([...grown(makeSelection({ points: ['a'] }), plan(), null).points].sort()).toEqual(['a', 'b', 'd', 'm']);
  });

  test('all and its inverse', () => {
    expect(everything(plan()).points.size).toBe(5);
    expect(inverted(emptySelection, plan(), topology()).rods.size).toBe(3);
    expect([...inverted(makeSelection({ points: ['a', 'b', 'c'] }), plan(), topology()).points]).toEqual(['d', 'm']);
    expect([...inverted(makeSelection({ nodes: [0] }), plan(), topology()).nodes].sort()).toEqual([1, 2, 3, 4]);
  });

  test('means the points of its rods when it has none of its own', () => {
    expect(pointsOf(makeSelection({ rods: ['cross'] }), plan())).toEqual(['a', 'm', 'c']);
    expect(pointsOf(makeSelection({ rods: ['cross'], points: ['d'] }), plan())).toEqual(['d']);
  });
});

describe('edits of a selection', () => {
  test('remove, ghost, kink, pin, attach', () => {
    expect(removal(emptySelection)).toBeNull();
    expect(removal(makeSelection({ rods: ['rim'] }))).toEqual({ name: 'remove', rods: ['rim'] });
    expect(ghosting(plan(), ['rim', 'shade'])).toEqual({ name: 'set_role', rods: ['rim', 'shade'], role: 'ghost' });
    expect(ghosting(plan(), ['shade'])).toMatchObject({ role: 'rod' });
    expect(ghosting(plan(), ['gone'])).toBeNull();
    expect(kinking(plan(), ['a'])).toEqual({ name: 'set_split', points: ['a'], split: true });
    expect(kinking(plan(), [])).toBeNull();
    const now = plan();
    now.constraints.pinned = ['a'];
    now.constraints.attached = [['b', 'a']];
    expect(pinning(now, ['a', 'b'])).toMatchObject({ pinned: ['a', 'b'] });
    expect(pinning(now, ['a'])).toMatchObject({ pinned: [] });
    expect(pinning(now, [])).toBeNull();
    expect(attaching(now, 'a', 'b')).toMatchObject({ attached: [] });
    expect(attaching(now, 'a', 'c')).toMatchObject({ attached: [['b', 'a'], ['a', 'c']] });
  });

  test('arrow keys move what is selected', () => {
    expect(nudge(plan(), makeSelection({ points: ['b'] }), [0.5, 0])).toEqual([{ point: 'b', to_mm: [10.5, 0] }]);
  });

  test('a cut finds the rod that runs through a point', () => {
    expect(rodThrough(plan(), 'm', emptySelection)?.name).toBe('cross');
    expect(rodThrough(plan(), 'a', emptySelection)?.name).toBe('rim');
    const both = plan();
    both.rods[2].points = [1, 4, 3];
    expect(rodThrough(both, 'm', makeSelection({ rods: ['shade'] }))?.name).toBe('shade');
  });
});

describe('the plan on the screen', () => {
  const screen = { width: 500, height: 300 };
  const camera = { center_mm: [10, 20] as [number, number], pixels_per_mm: 4 };

  test('mm to pixels and back, y upwards', () => {
    expect(toPixel(camera, screen, [11, 21])).toEqual([254, 146]);
    expect(toPlan(camera, screen, [254, 146])).toEqual([11, 21]);
  });

  test('zooming keeps the place under the pointer, shifting moves with it', () => {
    const held = toPlan(camera, screen, [400, 40]);
    const next = zoomPlan(camera, screen, [400, 40], 2.5);
    expect(toPixel(next, screen, held)[0]).toBeCloseTo(400, 9);
    expect(toPixel(next, screen, held)[1]).toBeCloseTo(40, 9);
    const shifted = toPixel(panPlan(camera, 7, -3), screen, [10, 20]);
    expect(shifted).toEqual([257, 147]);
  });

  test('fits all beside the rulers', () => {
    const fit = fitPlan([[0, 0], [100, 40]], screen, 20);
    if (!fit) throw new Error('nothing fitted');
    for (const corner of [[0, 0], [100, 0], [100, 40], [0, 40]] as [number, number][]) {
      const [x, y] = toPixel(fit, screen, corner);
      expect(x).toBeGreaterThan(20);
      expect(x).toBeLessThan(500);
      expect(y).toBeGreaterThan(20);
      expect(y).toBeLessThan(300);
    }
    expect(fitPlan([], screen, 20)).toBeNull();
  });
});
