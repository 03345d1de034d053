// The page's views against the real engine: what the pointer does in plan and space comes back as edits, shapes, pictures.

import { afterAll, beforeAll, beforeEach, describe, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { drag, idle, median, pixelOf, Studio, type Place } from './studio_browser';

let studio: Studio;
let page: Page;

beforeAll(async () => {
  studio = await Studio.start('butterfly');
  page = await studio.open();
}, 120_000);
afterAll(() => studio.end());

const counts = () => page.evaluate(() => window.lissomTest.counts());
const selected = () => page.evaluate(() => window.lissomTest.selection());
const camera = () => page.evaluate(() => window.lissomTest.camera());
const latencies = () => page.evaluate(() => window.lissomTest.latencies());

async function boxOf(name: string): Promise<{ left: number; top: number; width: number; height: number }> {
  const box = await page.getByRole('application', { name }).boundingBox();
  if (!box) throw new Error(`${name} is not on the page`);
  return { left: box.x, top: box.y, width: box.width, height: box.height };
}

/** A mode of work, by its tab. */
async function work(mode: string): Promise<void> {
  await page.getByRole('tab', { name: mode, exact: true }).click();
}

beforeEach(async () => {
  await page.mouse.up();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
});

test('the page is small, and nothing in it complains', async () => {
  expect(await counts()).toMatchObject({ points: 50, rods: 34, steps: 0 });
  const total = [...studio.bytes.values()].reduce((sum, n) => sum + n, 0);
  // Only what the tool itself serves is compressed.
  if (!process.env.LISSOM_STUDIO_PAGE) {
    expect(total).toBeGreaterThan(100_000);
    expect(total).toBeLessThan(250_000);
  }
  expect(studio.complaints).toEqual([]);
});

describe('the plan', () => {
  test('a dragged point is one step, and the shape follows while it moves', async () => {
    await page.evaluate(() => window.lissomTest.clearLatencies());
    const from = await pixelOf(page, 'f3-r', 'plan');
    await drag(page, from, [from[0] + 12, from[1] + 14], { steps: 20, pause: 80 });
    await idle(page);
    expect(await counts()).toMatchObject({ steps: 1, at: 1 });
    const times = await latencies();
    expect(times['pointer echo'].length).toBeGreaterThan(5);
    expect(times['move to shape'].length).toBeGreaterThan(0);
    expect(median(times.apply)).toBeLessThan(2);
    await page.keyboard.press('Control+z');
    await idle(page);
    expect(await counts()).toMatchObject({ steps: 1, at: 0 });
  });

  test('Escape gives a drag up', async () => {
    const before = JSON.stringify(await page.evaluate(() => window.lissomTest.plan()));
    const from = await pixelOf(page, 'h1-l', 'plan');
    await drag(page, from, [from[0] - 20, from[1]], { hold: true });
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await idle(page);
    const after = JSON.stringify(await page.evaluate(() => window.lissomTest.plan()));
    expect(JSON.parse(after).points).toEqual(JSON.parse(before).points);
  });

  test('arrow keys move what is selected', async () => {
    await page.mouse.click(...(await pixelOf(page, 'f3-l', 'plan')));
    await page.keyboard.press('ArrowUp');
    await idle(page);
    const [point] = await page.evaluate(() => (window.lissomTest.plan() as { points: { name: string; at_mm: number[] }[] }).points.filter((p) => p.name === 'f3-l'));
    expect(point.at_mm[1]).toBeCloseTo(93.5, 6);
    await page.keyboard.press('Control+z');
    await idle(page);
  });

  test('a rod is drawn by clicks and Enter', async () => {
    const { rods } = await counts();
    await page.keyboard.press('p');
    await page.mouse.click(...(await pixelOf(page, 'f2-l', 'plan')));
    await page.mouse.click(...(await pixelOf(page, 'k1-l', 'plan')));
    await page.keyboard.press('Enter');
    await page.keyboard.press('Escape');
    await expect.poll(async () => (await counts()).rods, { timeout: 10_000 }).toBe(rods + 1);
    await idle(page);
    await page.keyboard.press('Control+z');
    await expect.poll(async () => (await counts()).rods, { timeout: 10_000 }).toBe(rods);
    await idle(page);
  });
});

describe('the shape in space', () => {
  const place = (box: { left: number; top: number; width: number; height: number }, x: number, y: number): Place => [
    box.left + x * box.width,
    box.top + y * box.height,
  ];

  test('a click selects what the plan selects', async () => {
    await page.mouse.click(...(await pixelOf(page, 'k1-r', 'shape')));
    expect((await selected()).points).toEqual(['k1-r']);
    await page.keyboard.down('Shift');
    await page.mouse.click(...(await pixelOf(page, 'k2-r', 'plan')));
    await page.keyboard.up('Shift');
    expect((await selected()).points).toEqual(['k1-r', 'k2-r']);
  });

  test('boxes take what lies inside, or what they touch; a lasso what it goes round', async () => {
    const box = await boxOf('Shape in space');
    await drag(page, place(box, 0.47, 0.3), place(box, 0.95, 0.95));
    const inside = await selected();
    expect(inside.points.length).toBeGreaterThan(5);
    await drag(page, place(box, 0.95, 0.95), place(box, 0.47, 0.3));
    const touching = await selected();
    expect(touching.points.length).toBe(inside.points.length);
    expect(touching.rods.length).toBeGreaterThan(inside.rods.length);
    await page.keyboard.press('Escape');
    await page.keyboard.press('l');
    await page.mouse.move(...place(box, 0.2, 0.05));
    await page.mouse.down();
    for (const [x, y] of [[0.97, 0.05], [0.97, 0.97], [0.4, 0.97], [0.2, 0.97]]) await page.mouse.move(...place(box, x, y), { steps: 5 });
    await page.mouse.up();
    expect((await selected()).points.length).toBeGreaterThan(inside.points.length);
  });

  test('keys and the cube choose the view, the wheel zooms to the pointer', async () => {
    const back = async (key: string) => {
      await page.keyboard.press(key);
      await idle(page);
      return camera();
    };
    expect((await back('7')).pitch).toBeCloseTo(Math.PI / 2);
    expect(await back('1')).toMatchObject({ yaw: 0, pitch: 0 });
    expect((await back('3')).yaw).toBeCloseTo(Math.PI / 2);
    expect((await back('5')).orthographic).toBe(true);
    expect((await back('5')).orthographic).toBe(false);
    const face = page.getByRole('group', { name: 'View from' }).getByRole('button', { name: 'Back' });
    await face.focus();
    await page.keyboard.press('Enter');
    await idle(page);
    expect((await camera()).yaw).toBeCloseTo(Math.PI);
    await page.getByRole('group', { name: 'View from' }).getByRole('button', { name: 'Home' }).click();
    await idle(page);
    const at = await pixelOf(page, 'f3-r', 'shape');
    const { distance } = await camera();
    await page.mouse.move(...at);
    await page.mouse.wheel(0, -200);
    await expect.poll(async () => (await camera()).distance, { timeout: 10_000 }).toBeLessThan(distance);
    const now = await pixelOf(page, 'f3-r', 'shape');
    expect(Math.hypot(now[0] - at[0], now[1] - at[1])).toBeLessThan(25);
    await page.keyboard.press('Home');
    await idle(page);
  });

  test('it turns about what is selected', async () => {
    await page.mouse.click(...(await pixelOf(page, 'f3-r', 'shape')));
    const at = await pixelOf(page, 'f3-r', 'shape');
    const box = await boxOf('Shape in space');
    const { yaw } = await camera();
    await drag(page, place(box, 0.5, 0.9), place(box, 0.62, 0.85), { button: 'right' });
    expect(Math.abs((await camera()).yaw - yaw)).toBeGreaterThan(0.1);
    const now = await pixelOf(page, 'f3-r', 'shape');
    expect(Math.hypot(now[0] - at[0], now[1] - at[1])).toBeLessThan(1);
    await page.getByRole('group', { name: 'View from' }).getByRole('button', { name: 'Home' }).click();
    await idle(page);
  });

  test('a lost context comes back', async () => {
    const drawn = await page.evaluate(async () => {
      const gl = document.querySelector<HTMLCanvasElement>('.viewport canvas')?.getContext('webgl2');
      const lose = gl?.getExtension('WEBGL_lose_context');
      lose?.loseContext();
      await new Promise((done) => setTimeout(done, 200));
      const lost = gl?.isContextLost();
      lose?.restoreContext();
      await new Promise((done) => setTimeout(done, 800));
      return [lost, gl?.isContextLost()];
    });
    expect(drawn).toEqual([true, false]);
  });
});

test('Shape: hold, pull along an axis, make it real, take it back', async () => {
  await work('Shape');
  await page.evaluate(() => window.lissomTest.clearLatencies());
  await page.mouse.click(...(await pixelOf(page, 'f3-r', 'shape')));
  await page.waitForFunction(() => window.lissomTest.pixelOfGrip('z') !== null);
  const tip = (await page.evaluate(() => window.lissomTest.pixelOfGrip('z'))) as Place;
  await drag(page, tip, [tip[0], tip[1] - 10], { steps: 10, pause: 100 });
  await expect.poll(async () => (await latencies()).preview.length, { timeout: 20_000 }).toBeGreaterThan(2);
  const before = (await counts()).at;
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await counts()).at, { timeout: 60_000 }).toBe(before + 1);
  await idle(page);
  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await counts()).at, { timeout: 10_000 }).toBe(before);
  await idle(page);
  await work('Draw');
});

test('a killed studio that comes back finds its page, and the drag is given up', async () => {
  const points = await page.evaluate(() => (window.lissomTest.plan() as { points: object[] }).points);
  const from = await pixelOf(page, 'f3-l', 'plan');
  await drag(page, from, [from[0] + 10, from[1] + 10], { hold: true });
  await studio.kill();
  await expect.poll(() => page.evaluate(() => window.lissomTest.busy()), { timeout: 10_000 }).toBe('connection lost');
  await page.mouse.up();
  await studio.again();
  await idle(page);
  expect(await page.evaluate(() => (window.lissomTest.plan() as { points: object[] }).points)).toEqual(points);
  expect(studio.complaints.filter((text) => !text.includes('/live'))).toEqual([]);
});
