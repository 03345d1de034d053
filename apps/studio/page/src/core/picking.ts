// What is under the pointer. Points and rods are found in screen space, which is what the eye sees; triangles along the
// line of sight. Screens are (n, 3): pixels and depth, from Projector.all.

import type { TopologyPack } from './protocol';
import { cross, dot, row3, sub, type Vec2, type Vec3 } from './vec';

export interface SegmentHit {
  /** Number of the chain (rod) and of its edge counted over all chains. */
  chain: number;
  edge: number;
  /** Nodes at both ends and the place between them, 0 to 1. */
  nodes: [number, number];
  t: number;
  /** Pixels from the pointer. */
  distance: number;
  depth: number;
}

/** A lead in depth that is worth so many pixels: of two rods under the pointer the nearer one is meant. */
const kDepthWeight = 60;

/** Nearest edge of the rods within `reach` pixels. */
export function nearestSegment(screen: Float32Array, topology: TopologyPack, at: Vec2, reach: number): SegmentHit | null {
  let best: SegmentHit | null = null;
  let bestScore = Infinity;
  forEachEdge(topology, (chain, edge, a, b) => {
    const za = screen[3 * a + 2];
    const zb = screen[3 * b + 2];
    if (za > 1 || zb > 1) return;
    const { t, distance } = nearestOnSegment(
      at,
      [screen[3 * a], screen[3 * a + 1]],
      [screen[3 * b], screen[3 * b + 1]],
    );
    if (distance > reach) return;
    const depth = za + (zb - za) * t;
    const score = distance + kDepthWeight * depth;
    if (score < bestScore) {
      bestScore = score;
      best = { chain, edge, nodes: [a, b], t, distance, depth };
    }
  });
  return best;
}

/** Calls `use` with every edge of every rod: chain, number of the edge, its two nodes. */
export function forEachEdge(topology: TopologyPack, use: (chain: number, edge: number, a: number, b: number) => void): void {
  let edge = 0;
  topology.rods.forEach((rod, chain) => {
    const from = topology.rod_starts[chain];
    const to = topology.rod_starts[chain + 1];
    const count = rod.closed ? to - from : to - from - 1;
    for (let i = 0; i < count; ++i) {
      const next = i + 1 < to - from ? from + i + 1 : from;
      use(chain, edge++, topology.rod_nodes[from + i], topology.rod_nodes[next]);
    }
  });
}

export function nearestOnSegment(p: Vec2, a: Vec2, b: Vec2): { t: number; distance: number } {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const length = dx * dx + dy * dy;
  const t = length > 0 ? Math.min(1, Math.max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length)) : 0;
  return { t, distance: Math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy) };
}

/** Nearest point of a line through 2D points. */
export function nearestOnLine(p: Vec2, line: readonly Vec2[], closed = false) {
  let best = { index: 0, t: 0, distance: Infinity, at: line[0] ?? p };
  const count = closed ? line.length : line.length - 1;
  for (let i = 0; i < count; ++i) {
    const a = line[i];
    const b = line[(i + 1) % line.length];
    const { t, distance } = nearestOnSegment(p, a, b);
    if (distance < best.distance) {
      best = { index: i, t, distance, at: [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])] };
    }
  }
  return best;
}

/** Nearest of some rows of a screen within `reach` pixels: the row number, or -1. */
export function nearestPoint(screen: ArrayLike<number>, rows: Iterable<number>, at: Vec2, reach: number): number {
  let best = -1;
  let nearest = reach;
  for (const i of rows) {
    if (screen[3 * i + 2] > 1) continue;
    const distance = Math.hypot(screen[3 * i] - at[0], screen[3 * i + 1] - at[1]);
    if (distance <= nearest) {
      nearest = distance;
      best = i;
    }
  }
  return best;
}

export interface TriangleHit {
  triangle: number;
  /** Along the line of sight, mm. */
  distance: number;
  at: Vec3;
}

/** First triangle that a line of sight meets (Moeller and Trumbore 1997, both sides count). */
export function firstTriangle(
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  ray: { from: Vec3; along: Vec3 },
): TriangleHit | null {
  let best: TriangleHit | null = null;
  for (let i = 0; i + 2 < triangles.length; i += 3) {
    const a = row3(positions, triangles[i]);
    const ab = sub(row3(positions, triangles[i + 1]), a);
    const ac = sub(row3(positions, triangles[i + 2]), a);
    const p = cross(ray.along, ac);
    const determinant = dot(ab, p);
    if (Math.abs(determinant) < 1e-12) continue;
    const from = sub(ray.from, a);
    const u = dot(from, p) / determinant;
    if (u < 0 || u > 1) continue;
    const q = cross(from, ab);
    const v = dot(ray.along, q) / determinant;
    if (v < 0 || u + v > 1) continue;
    const distance = dot(ac, q) / determinant;
    if (distance > 0 && (!best || distance < best.distance)) {
      const { along } = ray;
      best = {
        triangle: i / 3,
        distance,
        at: [ray.from[0] + distance * along[0], ray.from[1] + distance * along[1], ray.from[2] + distance * along[2]],
      };
    }
  }
  return best;
}
