// The camera as plain numbers: a turntable about a pivot, Z up. Angles in radians, lengths in mm, screen in CSS pixels
// from the upper left.

import type { NamedView } from './store';
import { add, along, clamp, cross, dot, mix, mix3, multiply, scale, sub, transform, unit, type Mat4, type Vec2, type Vec3 } from './vec';

export interface Camera {
  target: Vec3;
  /** 0: looks along +y (front view); grows to the right of the object. */
  yaw: number;
  /** 0: level, pi/2: from above. */
  pitch: number;
  /** From target to eye. An orthographic picture shows what a perspective one shows at the target. */
  distance: number;
  orthographic: boolean;
}

export interface Screen {
  width: number;
  height: number;
}

/** Vertical opening, radians. */
export const kFieldOfView = (32 * Math.PI) / 180;
const kSteepest = Math.PI / 2;

export const homeCamera: Camera = {
  target: [0, 0, 0],
  yaw: 0.52,
  pitch: 0.56,
  distance: 600,
  orthographic: false,
};

const views: Record<NamedView, { yaw: number; pitch: number }> = {
  top: { yaw: 0, pitch: kSteepest },
  bottom: { yaw: 0, pitch: -kSteepest },
  front: { yaw: 0, pitch: 0 },
  back: { yaw: Math.PI, pitch: 0 },
  left: { yaw: -Math.PI / 2, pitch: 0 },
  right: { yaw: Math.PI / 2, pitch: 0 },
  home: { yaw: homeCamera.yaw, pitch: homeCamera.pitch },
};

/** Right, up and backward (from target to eye), each of length 1. */
export function axesOf(camera: Camera): { right: Vec3; up: Vec3; back: Vec3 } {
  const { yaw, pitch } = camera;
  const back: Vec3 = [Math.sin(yaw) * Math.cos(pitch), -Math.cos(yaw) * Math.cos(pitch), Math.sin(pitch)];
  const right: Vec3 = [Math.cos(yaw), Math.sin(yaw), 0];
  return { right, up: cross(back, right), back };
}

export function eyeOf(camera: Camera): Vec3 {
  return along(camera.target, axesOf(camera).back, camera.distance);
}

/** mm per pixel in the plane through the target. */
export function scaleOf(camera: Camera, screen: Screen): number {
  return (2 * camera.distance * Math.tan(kFieldOfView / 2)) / Math.max(screen.height, 1);
}

export function orbit(camera: Camera, dx: number, dy: number, screen: Screen): Camera {
  const turn = Math.PI / Math.max(screen.height, 300);
  return {
    ...camera,
    yaw: wrapped(camera.yaw - dx * turn),
    pitch: clamp(camera.pitch + dy * turn, -kSteepest, kSteepest),
  };
}

/** Turns about another place than the target: that place stays where it is in the picture. */
export function orbitAbout(camera: Camera, pivot: Vec3, dx: number, dy: number, screen: Screen): Camera {
  const turned = orbit(camera, dx, dy, screen);
  const away = sub(camera.target, pivot);
  const before = axesOf(camera);
  const after = axesOf(turned);
  let target = pivot;
  for (const axis of ['right', 'up', 'back'] as const) target = along(target, after[axis], dot(away, before[axis]));
  return { ...turned, target };
}

function wrapped(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}

export function pan(camera: Camera, dx: number, dy: number, screen: Screen): Camera {
  const { right, up } = axesOf(camera);
  const step = scaleOf(camera, screen);
  return { ...camera, target: along(along(camera.target, right, -dx * step), up, dy * step) };
}

/** Zooms by a factor (below 1: nearer) so that what is under the pointer stays there. */
export function zoom(camera: Camera, factor: number, at: Vec2, screen: Screen): Camera {
  const distance = clamp(camera.distance * factor, 0.5, 1e5);
  const kept = 1 - distance / camera.distance;
  const { right, up } = axesOf(camera);
  const step = scaleOf(camera, screen);
  const dx = (at[0] - screen.width / 2) * step * kept;
  const dy = (screen.height / 2 - at[1]) * step * kept;
  return { ...camera, distance, target: along(along(camera.target, right, dx), up, dy) };
}

/** Puts the pivot elsewhere; the eye turns to it by keeping its direction. */
export function about(camera: Camera, target: Vec3): Camera {
  return { ...camera, target };
}

export function named(camera: Camera, view: NamedView): Camera {
  return { ...camera, ...views[view] };
}

/** The whole of a box in the picture. */
export function fitted(camera: Camera, low: Vec3, high: Vec3, screen: Screen): Camera {
  const target = scale(add(low, high), 0.5);
  const { right, up, back } = axesOf(camera);
  const half = scale(sub(high, low), 0.5);
  const reach = (axis: Vec3) => Math.abs(axis[0]) * half[0] + Math.abs(axis[1]) * half[1] + Math.abs(axis[2]) * half[2];
  const opening = Math.tan(kFieldOfView / 2);
  const aspect = screen.width / Math.max(screen.height, 1);
  const needed = Math.max(reach(up) / opening, reach(right) / (opening * aspect), 1);
  const depth = camera.orthographic ? 0 : 0.5 * reach(back);
  return { ...camera, target, distance: 1.12 * needed + depth };
}

/** Between two cameras: t in [0, 1], eased at both ends, turning the short way round. */
export function eased(from: Camera, to: Camera, t: number): Camera {
  if (t >= 1) return to;
  const s = t * t * (3 - 2 * t);
  return {
    target: mix3(from.target, to.target, s),
    yaw: from.yaw + wrapped(to.yaw - from.yaw) * s,
    pitch: mix(from.pitch, to.pitch, s),
    distance: from.distance * Math.pow(to.distance / from.distance, s),
    orthographic: to.orthographic,
  };
}

export function viewMatrix(camera: Camera): Mat4 {
  const { right, up, back } = axesOf(camera);
  const eye = eyeOf(camera);
  return Float64Array.of(
    right[0], up[0], back[0], 0,
    right[1], up[1], back[1], 0,
    right[2], up[2], back[2], 0,
    -dot(right, eye), -dot(up, eye), -dot(back, eye), 1,
  );
}

export function projectionMatrix(camera: Camera, screen: Screen): Mat4 {
  const aspect = screen.width / Math.max(screen.height, 1);
  const near = camera.distance * 0.02;
  const far = camera.distance * 12;
  const top = Math.tan(kFieldOfView / 2);
  const m = new Float64Array(16);
  if (camera.orthographic) {
    m[0] = 1 / (top * aspect * camera.distance);
    m[5] = 1 / (top * camera.distance);
    // What lies behind the eye is shown too: an orthographic picture has no eye.
    m[10] = -1 / far;
    m[15] = 1;
    m[14] = -camera.distance / far;
    return m;
  }
  m[0] = 1 / (top * aspect);
  m[5] = 1 / top;
  m[10] = -(far + near) / (far - near);
  m[11] = -1;
  m[14] = (-2 * far * near) / (far - near);
  return m;
}

/** Projects points of space to pixels. */
export class Projector {
  private readonly matrix: Mat4;

  constructor(
    readonly camera: Camera,
    readonly screen: Screen,
  ) {
    this.matrix = multiply(projectionMatrix(camera, screen), viewMatrix(camera));
  }

  /** Pixel and depth (-1 near to 1 far); null behind the eye. */
  point(p: Vec3): Vec3 | null {
    const [x, y, z, w] = transform(this.matrix, p);
    if (w <= 1e-9) return null;
    return [(0.5 + (0.5 * x) / w) * this.screen.width, (0.5 - (0.5 * y) / w) * this.screen.height, z / w];
  }

  /** All rows of (n, 3) to (n, 3): pixel and depth; depth is 2 behind the eye. */
  all(data: ArrayLike<number>, out = new Float32Array(data.length)): Float32Array {
    const m = this.matrix;
    const { width, height } = this.screen;
    for (let i = 0; i + 2 < data.length; i += 3) {
      const x = data[i];
      const y = data[i + 1];
      const z = data[i + 2];
      const w = m[3] * x + m[7] * y + m[11] * z + m[15];
      const behind = w <= 1e-9;
      out[i] = (0.5 + (0.5 * (m[0] * x + m[4] * y + m[8] * z + m[12])) / w) * width;
      out[i + 1] = (0.5 - (0.5 * (m[1] * x + m[5] * y + m[9] * z + m[13])) / w) * height;
      out[i + 2] = behind ? 2 : (m[2] * x + m[6] * y + m[10] * z + m[14]) / w;
    }
    return out;
  }

  /** The line of sight through a pixel: a point on it and its direction, away from the eye. */
  ray(at: Vec2): { from: Vec3; along: Vec3 } {
    const { right, up, back } = axesOf(this.camera);
    const step = scaleOf(this.camera, this.screen);
    const dx = (at[0] - this.screen.width / 2) * step;
    const dy = (this.screen.height / 2 - at[1]) * step;
    const through = along(along(this.camera.target, right, dx), up, dy);
    if (this.camera.orthographic) return { from: along(through, back, 8 * this.camera.distance), along: scale(back, -1) };
    const eye = eyeOf(this.camera);
    return { from: eye, along: unit(sub(through, eye)) };
  }
}

/** Where a line of sight meets the plane through a point, square to `normal`; null when it runs along it. */
export function meet(ray: { from: Vec3; along: Vec3 }, through: Vec3, normal: Vec3): Vec3 | null {
  const slope = dot(ray.along, normal);
  if (Math.abs(slope) < 1e-6) return null;
  return along(ray.from, ray.along, dot(sub(through, ray.from), normal) / slope);
}

/** The place on the line (through a point along a unit axis) that is nearest to a line of sight, as a distance. */
export function slide(ray: { from: Vec3; along: Vec3 }, through: Vec3, axis: Vec3): number | null {
  const apart = sub(through, ray.from);
  const c = dot(ray.along, axis);
  const denominator = 1 - c * c;
  if (denominator < 1e-4) return null;
  return (c * dot(apart, ray.along) - dot(apart, axis)) / denominator;
}
