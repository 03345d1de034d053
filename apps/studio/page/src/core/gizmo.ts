// The combined handle as numbers: three arrows, three rings, a ball in the middle (moves in the plane of the screen) and
// a knob that scales. Sizes are pixels on the screen; what a drag does is worked out along lines of sight.

import { axesOf, kFieldOfView, meet, slide, type Projector } from './camera';
import { nearestOnSegment } from './picking';
import type { HandleMove, Vec2, Vec3 } from './protocol';
import { add, along, composed, cross, dot, norm, scale, sub, turned, unit } from './vec';

export type Grip = 'x' | 'y' | 'z' | 'turn-x' | 'turn-y' | 'turn-z' | 'screen' | 'scale';

export const kAxes: Record<'x' | 'y' | 'z', Vec3> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const kArrow = 74;
const kRing = 52;
const kReach = 9;
/** Rings are drawn as quarter arcs towards the eye: whole rings would hide the object. */
const kArcSteps = 16;

export interface GripLine {
  grip: Grip;
  /** Corners in space. */
  line: Vec3[];
}

/** mm per pixel at a place. */
export function pixelAt(projector: Projector, at: Vec3): number {
  const { camera, screen } = projector;
  const { back } = axesOf(camera);
  const depth = camera.orthographic ? camera.distance : camera.distance - dot(sub(at, camera.target), back);
  return (2 * Math.max(depth, 1e-6) * Math.tan(kFieldOfView / 2)) / Math.max(screen.height, 1);
}

/** What is drawn and what can be gripped. */
export function gripLines(projector: Projector, center: Vec3): GripLine[] {
  const size = pixelAt(projector, center);
  const eye = axesOf(projector.camera).back;
  const lines: GripLine[] = [];
  for (const name of ['x', 'y', 'z'] as const) {
    const axis = kAxes[name];
    lines.push({ grip: name, line: [along(center, axis, 14 * size), along(center, axis, kArrow * size)] });
    lines.push({ grip: `turn-${name}`, line: arc(center, axis, eye, kRing * size) });
  }
  const { right, up } = axesOf(projector.camera);
  const diagonal = unit(add(right, scale(up, -1)));
  lines.push({ grip: 'scale', line: [along(center, diagonal, 30 * size), along(center, diagonal, 62 * size)] });
  return lines;
}

/** A quarter of the circle about an axis, on the side of the eye. */
function arc(center: Vec3, axis: Vec3, eye: Vec3, radius: number): Vec3[] {
  const flat = sub(eye, scale(axis, dot(eye, axis)));
  const middle = norm(flat) > 1e-3 ? unit(flat) : unit(cross(axis, [0.3, 0.5, 0.8]));
  return Array.from({ length: kArcSteps + 1 }, (_, i) =>
    along(center, turned(middle, axis, (i / kArcSteps - 0.5) * (Math.PI / 2)), radius),
  );
}

/** What is under the pointer. */
export function gripAt(projector: Projector, center: Vec3, at: Vec2): Grip | null {
  const middle = projector.point(center);
  if (!middle) return null;
  if (Math.hypot(at[0] - middle[0], at[1] - middle[1]) < 11) return 'screen';
  let best: Grip | null = null;
  let nearest = kReach;
  for (const { grip, line } of gripLines(projector, center)) {
    for (let i = 1; i < line.length; ++i) {
      const a = projector.point(line[i - 1]);
      const b = projector.point(line[i]);
      if (!a || !b) continue;
      const { distance } = nearestOnSegment(at, [a[0], a[1]], [b[0], b[1]]);
      if (distance < nearest) {
        nearest = distance;
        best = grip;
      }
    }
  }
  return best;
}

export const restPose: HandleMove = { move_mm: [0, 0, 0], turn_deg: [0, 0, 0], scale: 1 };

/** The pose after the pointer has gone from one pixel to another with a grip held; `from` is the pose before. */
export function dragged(grip: Grip, projector: Projector, start: Vec3, from: HandleMove, a: Vec2, b: Vec2): HandleMove {
  const center = add(start, from.move_mm);
  const rays = [projector.ray(a), projector.ray(b)] as const;
  if (grip === 'x' || grip === 'y' || grip === 'z') {
    const [s, t] = rays.map((ray) => slide(ray, center, kAxes[grip]));
    return s === null || t === null ? from : { ...from, move_mm: along(from.move_mm, kAxes[grip], t - s) };
  }
  if (grip === 'screen') {
    const [s, t] = rays.map((ray) => meet(ray, center, axesOf(projector.camera).back));
    return s && t ? { ...from, move_mm: add(from.move_mm, sub(t, s)) } : from;
  }
  const middle = projector.point(center);
  if (!middle) return from;
  if (grip === 'scale') {
    const before = Math.max(Math.hypot(a[0] - middle[0], a[1] - middle[1]), 8);
    const after = Math.hypot(b[0] - middle[0], b[1] - middle[1]);
    return { ...from, scale: Math.min(Math.max((from.scale * after) / before, 0.05), 20) };
  }
  const axis = grip.slice(5) as 'x' | 'y' | 'z';
  const angle = angleAbout(kAxes[axis], projector, center, rays, a, b);
  const degree = Math.PI / 180;
  const turn = composed(scale(kAxes[axis], angle), scale(from.turn_deg, degree));
  return { ...from, turn_deg: scale(turn, 1 / degree) };
}

/** How far the pointer has gone round an axis: in the plane of the ring, or on the screen when that is seen edge on. */
function angleAbout(
  axis: Vec3,
  projector: Projector,
  center: Vec3,
  rays: readonly [{ from: Vec3; along: Vec3 }, { from: Vec3; along: Vec3 }],
  a: Vec2,
  b: Vec2,
): number {
  const facing = dot(axesOf(projector.camera).back, axis);
  const [s, t] = rays.map((ray) => meet(ray, center, axis));
  if (Math.abs(facing) > 0.2 && s && t) {
    const u = sub(s, center);
    const v = sub(t, center);
    return Math.atan2(dot(cross(u, v), axis), dot(u, v));
  }
  return (b[0] - a[0] - (b[1] - a[1])) / kRing;
}

/** A pose in words: "6.0 mm along x, 12°, 1.10 times". */
export function poseText(pose: HandleMove): string {
  const parts: string[] = [];
  ['x', 'y', 'z'].forEach((name, k) => {
    if (Math.abs(pose.move_mm[k]) > 5e-3) parts.push(`${name} ${pose.move_mm[k].toFixed(2)} mm`);
  });
  ['x', 'y', 'z'].forEach((name, k) => {
    if (Math.abs(pose.turn_deg[k]) > 5e-3) parts.push(`turn ${name} ${pose.turn_deg[k].toFixed(1)}°`);
  });
  if (Math.abs(pose.scale - 1) > 5e-4) parts.push(`× ${pose.scale.toFixed(3)}`);
  return parts.join(', ');
}
