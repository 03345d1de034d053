import { describe, expect, test } from 'vitest';
import { homeCamera, named, Projector } from '../../src/core/camera';
import { firstTriangle, nearestOnLine, nearestPoint, nearestSegment } from '../../src/core/picking';
import { pickPlan, pickPlanRegion } from '../../src/core/plan_picking';
import { boxRegion, inPolygon, lassoRegion, segmentTouches, boxOf } from '../../src/core/regions';
import { plan, shape, topology } from './fixtures';

const none = new Map();
const all = { points: true, rods: true };
const size = { width: 400, height: 400 };
const camera = { ...named(homeCamera, 'top'), target: [5, 5, 0] as [number, number, number], distance: 40, orthographic: true };

describe('picking in space', () => {
  const projector = new Projector(camera, size);
  const screen = projector.all(shape().positions);

  test('the nearest edge of a rod, and which', () => {
    const b = projector.point([10, 5, 0]) as [number, number, number];
    const hit = nearestSegment(screen, topology(), [b[0] + 3, b[1]], 8);
    expect(hit).toMatchObject({ chain: 0, edge: 1, nodes: [1, 2] });
    expect(hit?.t).toBeCloseTo(0.5, 4);
    expect(hit?.distance).toBeCloseTo(3, 3);
    expect(nearestSegment(screen, topology(), [b[0] + 30, b[1]], 8)).toBeNull();
  });

  test('the nearest point among some', () => {
    const m = projector.point([5, 5, 3]) as [number, number, number];
    expect(nearestPoint(screen, [0, 1, 2, 3, 4], [m[0] + 2, m[1]], 9)).toBe(4);
    expect(nearestPoint(screen, [0, 1], [m[0] + 2, m[1]], 9)).toBe(-1);
  });

  test('the first triangle along a line of sight', () => {
    const hit = firstTriangle(shape().positions, topology().triangles, { from: [5, 2, 50], along: [0, 0, -1] });
    expect(hit?.triangle).toBe(0);
    expect(hit?.at[2]).toBeCloseTo(3 * (2 / 5), 5);
    expect(firstTriangle(shape().positions, topology().triangles, { from: [50, 2, 50], along: [0, 0, -1] })).toBeNull();
  });
});

describe('picking in the plan', () => {
  test('points come before rods, rods before nothing', () => {
    expect(pickPlan(plan(), [9.7, 0.2], 1, 1, all, none)).toMatchObject({ kind: 'point', name: 'b' });
    expect(pickPlan(plan(), [5, 0.4], 1, 1, all, none)).toMatchObject({ kind: 'rod', name: 'rim', at: [5, 0] });
    expect(pickPlan(plan(), [9.7, 0.2], 1, 1, { points: false, rods: true }, none)).toMatchObject({ kind: 'rod' });
    expect(pickPlan(plan(), [7, 2], 0.5, 0.5, all, none)).toBeNull();
  });

  test('points are where the drag has them', () => {
    expect(pickPlan(plan(), [20, 20], 1, 1, all, new Map([['c', [20, 20.5]]]))).toMatchObject({ kind: 'point', name: 'c' });
  });

  test('the nearest place on a line', () => {
    expect(nearestOnLine([4, 3], [[0, 0], [10, 0], [10, 10]])).toMatchObject({ index: 0, at: [4, 0], distance: 3 });
    expect(nearestOnLine([0, 6], [[0, 0], [10, 0], [10, 10], [0, 10]], true)).toMatchObject({ index: 3, distance: 0 });
  });
});

describe('boxes and lassos', () => {
  test('left to right takes what lies inside, right to left what is touched', () => {
    const inside = pickPlanRegion(plan(), boxRegion([-1, -1], [7, 11]), all);
    expect([...inside.points].sort()).toEqual(['a', 'd', 'm']);
    expect([...inside.rods]).toEqual([]);
    const touching = pickPlanRegion(plan(), boxRegion([7, 11], [4.5, -1]), all);
    expect([...touching.points]).toEqual(['m']);
    expect([...touching.rods].sort()).toEqual(['cross', 'rim', 'shade']);
  });

  test('a lasso takes what lies inside', () => {
    const taken = pickPlanRegion(plan(), lassoRegion([[-1, -1], [12, -1], [12, 3], [-1, 12]]), all);
    expect([...taken.points].sort()).toEqual(['a', 'b', 'd', 'm']);
    expect([...taken.rods]).toEqual(['shade']);
    expect(inPolygon([[0, 0], [4, 0], [0, 4]], [3, 3])).toBe(false);
  });

  test('segments that only cross a box touch it', () => {
    const box = boxOf([2, 2], [4, 4]);
    expect(segmentTouches(box, [0, 3], [10, 3])).toBe(true);
    expect(segmentTouches(box, [0, 5], [10, 5])).toBe(false);
    expect(segmentTouches(box, [0, 0], [3, 10])).toBe(false);
    expect(segmentTouches(box, [3, 3], [3, 3])).toBe(true);
  });
});
