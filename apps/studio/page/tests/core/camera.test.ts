import { describe, expect, test } from 'vitest';
import {
  axesOf,
  eased,
  eyeOf,
  fitted,
  homeCamera,
  meet,
  named,
  orbit,
  orbitAbout,
  pan,
  Projector,
  scaleOf,
  slide,
  zoom,
  type Camera,
} from '../../src/core/camera';
import { cross, dot, norm, sub, type Vec3 } from '../../src/core/vec';

const screen = { width: 800, height: 600 };
const cameras: Camera[] = [homeCamera, { ...homeCamera, orthographic: true }, { ...homeCamera, yaw: 2.4, pitch: -0.7, target: [12, -5, 30] }];

describe('camera', () => {
  test.each(cameras)('axes are a right-handed frame, z is up on the screen', (camera) => {
    const { right, up, back } = axesOf(camera);
    expect(norm(sub(cross(right, up), back))).toBeLessThan(1e-12);
    expect(up[2]).toBeGreaterThan(0);
  });

  test.each(cameras)('the target is in the middle, lines of sight go back to where they came from', (camera) => {
    const projector = new Projector(camera, screen);
    const middle = projector.point(camera.target);
    expect(middle?.[0]).toBeCloseTo(400, 6);
    expect(middle?.[1]).toBeCloseTo(300, 6);
    const place: Vec3 = [camera.target[0] + 20, camera.target[1] - 35, camera.target[2] + 11];
    const pixel = projector.point(place) as Vec3;
    const ray = projector.ray([pixel[0], pixel[1]]);
    const off = cross(sub(place, ray.from), ray.along);
    expect(norm(off)).toBeLessThan(1e-6);
    const all = projector.all(Float32Array.from(place));
    expect(all[0]).toBeCloseTo(pixel[0], 3);
    expect(all[2]).toBeCloseTo(pixel[2], 4);
  });

  test('what is behind the eye has no pixel', () => {
    const eye = eyeOf(homeCamera);
    const behind: Vec3 = [2 * eye[0], 2 * eye[1], 2 * eye[2]];
    const projector = new Projector(homeCamera, screen);
    expect(projector.point(behind)).toBeNull();
    expect(projector.all(Float32Array.from(behind))[2]).toBe(2);
  });

  test.each(cameras)('zooming keeps what is under the pointer in the plane of the target', (camera) => {
    const at: [number, number] = [610, 140];
    const held = meet(new Projector(camera, screen).ray(at), camera.target, axesOf(camera).back) as Vec3;
    const next = zoom(camera, 0.6, at, screen);
    const pixel = new Projector(next, screen).point(held) as Vec3;
    expect(pixel[0]).toBeCloseTo(at[0], 6);
    expect(pixel[1]).toBeCloseTo(at[1], 6);
    expect(next.distance).toBeCloseTo(0.6 * camera.distance, 9);
  });

  test('turning about a place keeps its pixel', () => {
    const pivot: Vec3 = [40, 25, -10];
    const before = new Projector(homeCamera, screen).point(pivot) as Vec3;
    const after = new Projector(orbitAbout(homeCamera, pivot, 130, -40, screen), screen).point(pivot) as Vec3;
    expect(after[0]).toBeCloseTo(before[0], 6);
    expect(after[1]).toBeCloseTo(before[1], 6);
  });

  test('shifting moves the picture with the pointer', () => {
    const place = homeCamera.target;
    const pixel = new Projector(pan(homeCamera, 37, -12, screen), screen).point(place) as Vec3;
    expect(pixel[0]).toBeCloseTo(437, 6);
    expect(pixel[1]).toBeCloseTo(288, 6);
  });

  test('turning stops at the poles', () => {
    expect(orbit(homeCamera, 0, 1e5, screen).pitch).toBeCloseTo(Math.PI / 2, 9);
    expect(axesOf(orbit(homeCamera, 0, 1e5, screen)).back[2]).toBeCloseTo(1, 9);
  });

  test('named views look along the axes', () => {
    expect(axesOf(named(homeCamera, 'top')).back[2]).toBeCloseTo(1);
    expect(axesOf(named(homeCamera, 'front')).back[1]).toBeCloseTo(-1);
    expect(axesOf(named(homeCamera, 'right')).back[0]).toBeCloseTo(1);
    expect(axesOf(named(homeCamera, 'left')).back[0]).toBeCloseTo(-1);
    expect(axesOf(named(homeCamera, 'back')).back[1]).toBeCloseTo(1);
    expect(axesOf(named(homeCamera, 'bottom')).back[2]).toBeCloseTo(-1);
  });

  test.each(cameras)('a fitted box is inside the picture and fills more than half of it', (camera) => {
    const low: Vec3 = [-120, -90, 0];
    const high: Vec3 = [120, 90, 27];
    const projector = new Projector(fitted(camera, low, high, screen), screen);
    const pixels = [0, 1, 2, 3, 4, 5, 6, 7].map((c) => projector.point([c & 1 ? low[0] : high[0], c & 2 ? low[1] : high[1], c & 4 ? low[2] : high[2]]) as Vec3);
    const xs = pixels.map((p) => p[0]);
    const ys = pixels.map((p) => p[1]);
    expect(Math.min(...xs)).toBeGreaterThan(0);
    expect(Math.max(...xs)).toBeLessThan(800);
    expect(Math.min(...ys)).toBeGreaterThan(0);
    expect(Math.max(...ys)).toBeLessThan(600);
    expect(Math.max((Math.max(...xs) - Math.min(...xs)) / 800, (Math.max(...ys) - Math.min(...ys)) / 600)).toBeGreaterThan(0.5);
  });

  test('easing starts and ends where it should and turns the short way', () => {
    const from = { ...homeCamera, yaw: 3 };
    const to = { ...homeCamera, yaw: -3, distance: 100 };
    expect(eased(from, to, 0).yaw).toBeCloseTo(3);
    expect(eased(from, to, 1)).toEqual(to);
    expect(Math.abs(eased(from, to, 0.5).yaw)).toBeGreaterThan(3);
    expect(eased(from, to, 0.5).distance).toBeCloseTo(Math.sqrt(600 * 100));
  });

  test('a line of sight slides along an axis', () => {
    const ray = { from: [5, 100, 3] as Vec3, along: [0, -1, 0] as Vec3 };
    expect(slide(ray, [1, 0, 3], [1, 0, 0])).toBeCloseTo(4);
    expect(slide(ray, [1, 0, 3], [0, 1, 0])).toBeNull();
    expect(meet(ray, [0, 0, 0], [1, 0, 0])).toBeNull();
    expect(dot(meet(ray, [0, 7, 0], [0, 1, 0]) as Vec3, [0, 1, 0])).toBeCloseTo(7);
  });

  test('a pixel at the target is as large as the scale says', () => {
    const { right } = axesOf(homeCamera);
    const step = scaleOf(homeCamera, screen);
    const pixel = new Projector(homeCamera, screen).point([right[0] * step * 50, right[1] * step * 50, 0]) as Vec3;
    expect(pixel[0]).toBeCloseTo(450, 4);
  });
});
