// Small vectors and column-major 4x4 matrices (as WebGL wants them); nothing here allocates but its result.

import type { Vec2, Vec3 } from './protocol';

export type Mat4 = Float64Array;
export type { Vec2, Vec3 };

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
/** a + s b. */
export const along = (a: Vec3, b: Vec3, s: number): Vec3 => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const norm = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);
export const mix = (a: number, b: number, t: number): number => a + (b - a) * t;
export const mix3 = (a: Vec3, b: Vec3, t: number): Vec3 => [mix(a[0], b[0], t), mix(a[1], b[1], t), mix(a[2], b[2], t)];
export const clamp = (x: number, low: number, high: number): number => Math.min(Math.max(x, low), high);
export const distance2 = (a: Vec2, b: Vec2): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** a / |a|; [0, 0, 0] stays. */
export function unit(a: Vec3): Vec3 {
  const length = norm(a);
  return length > 0 ? scale(a, 1 / length) : a;
}

/** Row i of an array of shape (n, 3). */
export function row3(data: ArrayLike<number>, i: number): Vec3 {
  return [data[3 * i], data[3 * i + 1], data[3 * i + 2]];
}

export function multiply(a: Mat4, b: Mat4): Mat4 {
  const out = new Float64Array(16);
  for (let column = 0; column < 4; ++column) {
    for (let row = 0; row < 4; ++row) {
      let sum = 0;
      for (let k = 0; k < 4; ++k) sum += a[4 * k + row] * b[4 * column + k];
      out[4 * column + row] = sum;
    }
  }
  return out;
}

/** m (p, 1): homogeneous. */
export function transform(m: Mat4, p: Vec3): [number, number, number, number] {
  const [x, y, z] = p;
  return [
    m[0] * x + m[4] * y + m[8] * z + m[12],
    m[1] * x + m[5] * y + m[9] * z + m[13],
    m[2] * x + m[6] * y + m[10] * z + m[14],
    m[3] * x + m[7] * y + m[11] * z + m[15],
  ];
}

/** p turned about the axis (of length 1) through the origin, radians. */
export function turned(p: Vec3, axis: Vec3, angle: number): Vec3 {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const side = cross(axis, p);
  const keep = dot(axis, p) * (1 - c);
  return [p[0] * c + side[0] * s + axis[0] * keep, p[1] * c + side[1] * s + axis[1] * keep, p[2] * c + side[2] * s + axis[2] * keep];
}

/** The rotation vector (radians) of `first`, then `second` (Rodrigues' formula by quaternions). */
export function composed(second: Vec3, first: Vec3): Vec3 {
  const [w2, v2] = quaternion(second);
  const [w1, v1] = quaternion(first);
  const w = w2 * w1 - dot(v2, v1);
  const v = add(add(scale(v1, w2), scale(v2, w1)), cross(v2, v1));
  const length = norm(v);
  if (length < 1e-15) return [0, 0, 0];
  // Of the two ways round the shorter one.
  const angle = 2 * Math.atan2(length, Math.abs(w)) * (w < 0 ? -1 : 1);
  return scale(v, angle / length);
}

function quaternion(rotation: Vec3): [number, Vec3] {
  const angle = norm(rotation);
  if (angle < 1e-15) return [1, scale(rotation, 0.5)];
  return [Math.cos(angle / 2), scale(rotation, Math.sin(angle / 2) / angle)];
}

/** Low and high corner of an array of shape (n, 3); null when there is no finite point. */
export function bounds(data: ArrayLike<number>): { low: Vec3; high: Vec3 } | null {
  const low: Vec3 = [Infinity, Infinity, Infinity];
  const high: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i + 2 < data.length; i += 3) {
    for (let k = 0; k < 3; ++k) {
      const x = data[i + k];
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
  }
  return low[0] <= high[0] ? { low, high } : null;
}
