import { describe, expect, test } from 'vitest';
import { chainsOf, fillSlots, slotRadii, tubeMesh } from '../../src/core/chains';
import { colourAt, colourOf, colourTable, css } from '../../src/core/colours';
import { FabricFrame, setWeights } from '../../src/core/fabric_frame';
import { hull, lockRange } from '../../src/core/fields';
import { marks, niceLength, niceStep } from '../../src/core/scale_bar';
import { makeSelection } from '../../src/core/selection';
import { falloff, nodesOf, ring, softWeights } from '../../src/core/soft';
import { rodRange } from '../../src/core/store';
import { names, shape, topology } from './fixtures';

describe('rods as tubes', () => {
  const chains = chainsOf(topology());

  test('slots know their neighbours; closed rods go round', () => {
    expect([...chains.previous]).toEqual([3, 0, 1, 2, 4, 4, 5]);
    expect([...chains.next]).toEqual([1, 2, 3, 0, 5, 6, 6]);
    expect([...chains.edgeBefore]).toEqual([3, 0, 1, 2, 4, 4, 5]);
    expect([...chains.edgeAfter]).toEqual([0, 1, 2, 3, 4, 5, 5]);
    expect([...chains.firstEdge]).toEqual([0, 4, 6]);
  });

  test('a frame puts places, mean axes and mean values into slots', () => {
    const out = new Float32Array(8 * chains.count);
    const { positions, normals, edge_values } = shape();
    normals.set([0, 0, -1], 15); // the last edge's axis points the other way: the same ellipse
    fillSlots(chains, topology().rod_nodes, positions, normals, edge_values, out);
    expect([...out.subarray(8, 11)]).toEqual([10, 0, 0]);
    expect(out[8 + 3]).toBeCloseTo(0.5);
    expect([...out.subarray(8 * 5 + 4, 8 * 5 + 7)]).toEqual([0, 0, 2]);
    expect(out[8 * 5 + 3]).toBeCloseTo(4.5);
    fillSlots(chains, topology().rod_nodes, positions, normals, null, out);
    expect(out[8 + 3]).toBe(0);
  });

  test('radii of slots are means of their edges', () => {
    const radii = topology().edge_radii.slice();
    radii[8] = 0.8;
    const slots = slotRadii(chains, radii);
    expect(slots[2 * 4]).toBeCloseTo(0.8);
    expect(slots[2 * 5]).toBeCloseTo(0.6);
  });

  test('rings are shared: one per node, caps at open ends only, indices in range', () => {
    const sides = 6;
    const { vertices, index } = tubeMesh(topology(), chains, sides);
    expect(vertices.length / 4).toBe(7 * sides + 2 * (sides + 1));
    expect(index.length / 3).toBe((4 + 2) * sides * 2 + 2 * sides);
    expect(Math.max(...index)).toBe(vertices.length / 4 - 1);
  });
});

describe('fabric', () => {
  test('normals, thickness and values at the vertices', () => {
    const { plan_places, triangles } = topology();
    const frame = new FabricFrame(triangles, plan_places, names.length);
    const flat = shape(0);
    frame.update(flat.positions, flat.triangle_values);
    const up = frame.normals.subarray(12, 15);
    expect([up[0], up[1]]).toEqual([0, 0]);
    expect(up[2]).toBeGreaterThan(0);
    expect(frame.extra[3 * 4]).toBeCloseTo(1);
    expect(frame.extra[3 * 4 + 1]).toBeCloseTo(1.25);
    expect(frame.extra[1]).toBeCloseTo(1.25);
    expect(frame.extra[4]).toBeCloseTo(1.15);
    frame.update(shape(5).positions, null);
    expect(frame.extra[3 * 4]).toBeCloseTo(Math.SQRT1_2, 5);
    expect(frame.extra[3 * 4 + 1]).toBe(0);
    setWeights(frame.extra, Float32Array.of(0, 0.5, 0, 0, 1));
    expect(frame.extra[3 * 1 + 2]).toBe(0.5);
    frame.update(shape(5).positions, null);
    expect(frame.extra[3 * 1 + 2]).toBe(0.5);
    setWeights(frame.extra, null);
    expect(frame.extra[3 * 1 + 2]).toBe(0);
  });

  test('5,000 vertices take less than 2 ms', () => {
    const side = 71;
    const places = new Float32Array(2 * side * side);
    const positions = new Float32Array(3 * side * side);
    const triangles: number[] = [];
    for (let i = 0; i < side; ++i) {
      for (let j = 0; j < side; ++j) {
        places.set([i, j], 2 * (i * side + j));
        positions.set([i, j, Math.sin(i / 9) * Math.cos(j / 7)], 3 * (i * side + j));
        if (i + 1 < side && j + 1 < side) {
          const a = i * side + j;
          triangles.push(a, a + side, a + 1, a + 1, a + side, a + side + 1);
        }
      }
    }
    const frame = new FabricFrame(Uint32Array.from(triangles), places, side * side);
    const values = new Float32Array(triangles.length / 3).fill(1.2);
    const times = Array.from({ length: 60 }, () => {
      const start = performance.now();
      frame.update(positions, values);
      return performance.now() - start;
    }).sort((a, b) => a - b);
    // The lower quartile: what the work takes when the machine leaves it alone.
    expect(times[15]).toBeLessThan(2);
  });
});

describe('colours', () => {
  test('blue is compression, red tension, light the middle', () => {
    const [low, middle, high] = [0, 0.5, 1].map((t) => colourAt(true, t));
    expect(low[2]).toBeGreaterThan(low[0]);
    expect(high[0]).toBeGreaterThan(high[2]);
    expect(Math.min(...middle)).toBeGreaterThan(230);
  });

  test('the sequential map gets lighter at every step', () => {
    const light = ([r, g, b]: number[]) => 0.2126 * (r / 255) ** 2.2 + 0.7152 * (g / 255) ** 2.2 + 0.0722 * (b / 255) ** 2.2;
    const steps = Array.from({ length: 33 }, (_, i) => light(colourAt(false, i / 32)));
    steps.slice(1).forEach((l, i) => expect(l).toBeGreaterThan(steps[i]));
  });

  test('values beyond the range have the colours of its ends', () => {
    expect(colourOf(-9, 0, 1, false)).toEqual(colourAt(false, 0));
    expect(colourOf(9, 0, 1, false)).toEqual(colourAt(false, 1));
    expect(colourOf(3, 3, 3, true)).toEqual(colourAt(true, 0.5));
    expect(colourTable(true, 4)).toHaveLength(16);
    expect(css([1, 2, 3])).toBe('rgb(1 2 3)');
  });

  test('ranges are symmetric for diverging fields and never empty', () => {
    const field = { name: 'f', unit: '', low: -1, high: 3, diverging: true };
    expect(hull(field)).toEqual([-3, 3]);
    expect(hull({ ...field, diverging: false })).toEqual([-1, 3]);
    expect(hull({ ...field, low: 2, high: 2, diverging: false })).toEqual([2, 3]);
    lockRange(rodRange, 1, 0);
    expect(rodRange.value.locked).toBe(true);
    expect(rodRange.value.high).toBeGreaterThan(rodRange.value.low);
    rodRange.value = { low: 0, high: 1, locked: false };
  });
});

describe('soft selection', () => {
  test('falls from 1 to 0 smoothly', () => {
    expect(falloff(0, 10)).toBe(1);
    expect(falloff(10, 10)).toBe(0);
    expect(falloff(5, 10)).toBeCloseTo(0.5625);
    const weights = softWeights(shape(0).positions, [0], 12);
    expect(weights[0]).toBe(1);
    expect(weights[4]).toBeCloseTo(falloff(Math.SQRT2 * 5, 12), 5);
    expect(weights[2]).toBe(0);
  });

  test('means nodes and the nodes of points', () => {
    const index = new Map(names.map((n, i) => [n, i]));
    expect(nodesOf(makeSelection({ points: ['m', 'gone'], nodes: [1] }), index, topology()).sort()).toEqual([1, 4]);
    expect(ring([5, 5], 3, 4)[1][1]).toBeCloseTo(8);
  });
});

test('scales and rulers have lengths that people like', () => {
  expect([niceLength(110), niceLength(49), niceLength(0.3), niceLength(20)]).toEqual([100, 20, 0.2, 20]);
  expect([niceStep(3), niceStep(0.12), niceStep(10), niceStep(60)]).toEqual([5, 0.2, 10, 100]);
  expect(marks(-6, 11, 5, 2)).toEqual([
    { at: -5, label: '' },
    { at: 0, label: '0' },
    { at: 5, label: '' },
    { at: 10, label: '10' },
  ]);
});
