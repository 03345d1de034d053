import { describe, expect, test } from 'vitest';
import { homeCamera, Projector } from '../../src/core/camera';
import { dragged, gripAt, gripLines, kAxes, pixelAt, poseText, restPose } from '../../src/core/gizmo';
import { composed, type Vec2, type Vec3 } from '../../src/core/vec';

const screen = { width: 900, height: 700 };
const center: Vec3 = [20, 10, 5];
const projectors = [homeCamera, { ...homeCamera, orthographic: true }].map((camera) => new Projector(camera, screen));
const pixel = (projector: Projector, p: Vec3): Vec2 => (projector.point(p) as Vec3).slice(0, 2) as Vec2;

describe.each(projectors)('handle', (projector) => {
  test('has the same size on the screen wherever it stands', () => {
    const [first] = gripLines(projector, center).filter((l) => l.grip === 'z');
    const [a, b] = first.line.map((p) => pixel(projector, p));
    expect(Math.hypot(b[0] - a[0], b[1] - a[1])).toBeGreaterThan(40);
    expect(Math.hypot(b[0] - a[0], b[1] - a[1])).toBeLessThan(62);
    expect(pixelAt(projector, center)).toBeGreaterThan(0);
  });

  test('grips are where they are drawn', () => {
    for (const { grip, line } of gripLines(projector, center)) {
      const end = pixel(projector, line[line.length - 1]);
      expect(gripAt(projector, center, end)).toBe(grip);
    }
    expect(gripAt(projector, center, pixel(projector, center))).toBe('screen');
    expect(gripAt(projector, center, [3, 3])).toBeNull();
  });

  test.each(['x', 'y', 'z'] as const)('an arrow moves along %s as far as the pointer goes', (axis) => {
    const to = center.map((c, k) => c + 14 * kAxes[axis][k]) as Vec3;
    const pose = dragged(axis, projector, center, restPose, pixel(projector, center), pixel(projector, to));
    pose.move_mm.forEach((m, k) => expect(m).toBeCloseTo(14 * kAxes[axis][k], 4));
  });

  test('the ball moves in the plane of the screen', () => {
    const from = pixel(projector, center);
    const pose = dragged('screen', projector, center, restPose, from, [from[0] + 60, from[1] - 25]);
    const moved = center.map((c, k) => c + pose.move_mm[k]) as Vec3;
    expect(pixel(projector, moved)[0]).toBeCloseTo(from[0] + 60, 3);
    expect(pixel(projector, moved)[1]).toBeCloseTo(from[1] - 25, 3);
  });

  test('a ring turns about its axis', () => {
    const at = (angle: number): Vec2 => pixel(projector, [center[0] + 30 * Math.cos(angle), center[1] + 30 * Math.sin(angle), center[2]]);
    const pose = dragged('turn-z', projector, center, restPose, at(0.2), at(0.9));
    expect(pose.turn_deg[2]).toBeCloseTo((0.7 * 180) / Math.PI, 3);
    expect(pose.turn_deg[0]).toBeCloseTo(0, 6);
  });

  test('the knob scales by the distance from the middle', () => {
    const m = pixel(projector, center);
    const pose = dragged('scale', projector, center, restPose, [m[0] + 50, m[1]], [m[0] + 75, m[1]]);
    expect(pose.scale).toBeCloseTo(1.5, 6);
  });
});

test('rings seen edge on turn by the way on the screen', () => {
  const projector = new Projector({ ...homeCamera, pitch: 0, yaw: 0 }, screen);
  const pose = dragged('turn-z', projector, center, restPose, [400, 300], [452, 300]);
  expect(pose.turn_deg[2]).toBeCloseTo(180 / Math.PI, 6);
});

test('rotations follow each other', () => {
  const quarter = Math.PI / 2;
  const turned = composed([0, 0, quarter], [quarter, 0, 0]);
  const third = (2 * Math.PI) / 3 / Math.sqrt(3);
  turned.forEach((x) => expect(x).toBeCloseTo(third, 9));
  composed([0, 0, 0], [0.1, 0.2, 0.3]).forEach((x, k) => expect(x).toBeCloseTo([0.1, 0.2, 0.3][k], 12));
  composed([0, 0, 3], [0, 0, 3]).forEach((x, k) => expect(x).toBeCloseTo([0, 0, 6 - 2 * Math.PI][k], 9));
  expect(composed([0, 0, 0], [0, 0, 0])).toEqual([0, 0, 0]);
});

test('a pose in words', () => {
  expect(poseText(restPose)).toBe('');
  expect(poseText({ move_mm: [0, 0, 12.5], turn_deg: [0, 5, 0], scale: 1.1 })).toBe('z 12.50 mm, turn y 5.0°, × 1.100');
});
