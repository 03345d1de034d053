import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { edgeStarts, nodesOfEdge, valuesOfRod } from '../../src/panels/logic/edges';
import { picture, projected } from '../../src/panels/logic/projection';
import { Scrub } from '../../src/panels/logic/scrub';
import { openAtFirst, treeKey, treeRows } from '../../src/panels/logic/tree_rows';
import { plan } from './scene';

const scene = { plan: plan(), shapes: [{ key: 'shape:flat', title: 'Flat plan', detail: 'hidden' }], sets: [] };

test('the tree is the scene as text', () => {
  const rows = treeRows(scene, new Set(openAtFirst));
  expect(rows.map((row) => row.title)).toEqual([
    'Fabric', 'Hole 1', 'Rods (2)', 'rim', 'rib', 'Points (4)', 'Pins (1)', 'a', 'Attachments (1)', 'a to c', 'Planes and symmetry (2)', 'Shapes (1)',
  ]);
  expect(rows.find((row) => row.title === 'rib')).toMatchObject({ level: 2, place: 2, siblings: 2, open: false, rods: ['rib'], detail: 'ghost, 100\u00a0mm' });
  expect(new Set(rows.map((row) => row.key)).size).toBe(rows.length);
  const inside = treeRows(scene, new Set(['rods', 'rod:rim'])).filter((row) => row.level === 3);
  expect(inside.map((row) => row.title)).toEqual(['a', 'b', 'c']);
});

test('keys lead through the tree', () => {
  const rows = treeRows(scene, new Set(openAtFirst));
  const at = (title: string) => rows.findIndex((row) => row.title === title);
  expect(treeKey(rows, at('rim'), 'ArrowDown')).toEqual({ to: 'rod:rib' });
  expect(treeKey(rows, at('rim'), 'ArrowRight')).toEqual({ open: true });
  expect(treeKey(rows, at('rim'), 'ArrowLeft')).toEqual({ to: 'rods' });
  expect(treeKey(rows, at('Rods (2)'), 'ArrowLeft')).toEqual({ open: false });
  expect(treeKey(rows, 0, 'End')).toEqual({ to: 'shapes' });
  expect(treeKey(rows, 0, 'r')).toEqual({ to: 'rods' });
  expect(treeKey(rows, 0, 'ArrowUp')).toBeUndefined();
});

const mesh = {
  rods: [
    { name: 'ring', plan_rod: 'ring', closed: true },
    { name: 'bar', plan_rod: 'bar', closed: false },
  ],
  rod_starts: new Uint32Array([0, 3, 6]),
  rod_nodes: new Uint32Array([0, 1, 2, 2, 3, 4]),
};

test('edges run rod by rod', () => {
  expect(edgeStarts(mesh)).toEqual([0, 3, 5]);
  expect(nodesOfEdge(mesh, 2)).toEqual({ rod: 0, nodes: [2, 0] });
  expect(nodesOfEdge(mesh, 3)).toEqual({ rod: 1, nodes: [2, 3] });
  expect(nodesOfEdge(mesh, 5)).toBeUndefined();
  expect(valuesOfRod(mesh, 'bar', [1, 2, 3, 4, 5])).toEqual([4, 5]);
});

test('small pictures show height upwards', () => {
  expect(projected(0, 0, 10)[1]).toBeLessThan(projected(0, 0, 0)[1]);
  const drawn = picture([0, 0, 0, 10, 0, 0, 20, 0, 0], [{ nodes: [0, 1, 2] }], 0, 2);
  expect(drawn.path.match(/[ML]/g)).toEqual(['M', 'L']);
  expect(picture([], []).path).toBe('');
});

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('a run of changes is one step', () => {
  const previews: number[] = [];
  const commits: number[] = [];
  const scrub = new Scrub(() => ({ preview: (v) => previews.push(v), commit: (v) => commits.push(v) }), 600);
  scrub.move(1);
  scrub.move(2);
  vi.advanceTimersByTime(5000);
  expect(commits).toEqual([]);
  expect(scrub.pending).toBe(2);
  scrub.end();
  scrub.end();
  expect(commits).toEqual([2]);
  scrub.step(3);
  vi.advanceTimersByTime(500);
  scrub.step(4);
  vi.advanceTimersByTime(599);
  expect(commits).toEqual([2]);
  vi.advanceTimersByTime(1);
  expect(commits).toEqual([2, 4]);
  expect(previews).toEqual([1, 2, 3, 4]);
});
