// How fast the studio answers while somebody edits the designs of the gallery: the real tool, the real page, Chromium without
// a graphics card. Rows of name, metric, value, unit, as from the other benches; times are the page's own (core/latency.ts).
//   python3 tools/page_tests.py tests/studio/live_speed_bench.ts

import { afterEach, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { drag, idle, median, pixelOf, Studio, type Place } from './studio_browser';

const designs = [
  { name: 'butterfly', moved: 'f3-l', pulled: 'f3-l' },
  { name: 'mask', moved: 'm1-l', pulled: 'nose' },
  { name: 'car', moved: 'w2-l', pulled: 'roof' },
];

let studio: Studio | null = null;
afterEach(async () => {
  await studio?.end();
  studio = null;
});

function row(design: string, metric: string, values: readonly number[]): void {
  const [middle, most] = [median(values), Math.max(...values)];
  process.stdout.write(`${design}\t${metric}\t${middle.toFixed(1)}\tms\t(of ${values.length}, most ${most.toFixed(0)})\n`);
}

const latencies = (page: Page) => page.evaluate(() => window.lissomTest.latencies());
const clear = (page: Page) => page.evaluate(() => window.lissomTest.clearLatencies());
const steps = (page: Page) => page.evaluate(() => window.lissomTest.counts().at);

/** A long drag, then moves one at a time, each of which settles. */
async function edit(page: Page, design: string, point: string): Promise<void> {
  const from = await pixelOf(page, point, 'plan');
  await clear(page);
  await drag(page, from, [from[0] + 6, from[1] + 4], { steps: 40, pause: 33 });
  await idle(page);
  const along = await latencies(page);
  row(design, 'pointer echo', along['pointer echo']);
  row(design, 'move to shape, in a drag', along['move to shape']);
  expect(along['move to shape'].length).toBeGreaterThan(0);
  await page.keyboard.press('Control+z');
  await idle(page);

  await clear(page);
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let i = 1; i <= 10; ++i) {
    await page.mouse.move(from[0] + i, from[1] + (i % 2));
    await page.waitForTimeout(200);
    await idleInDrag(page);
  }
  await page.mouse.up();
  await idle(page);
  const single = await latencies(page);
  row(design, 'move to shape, single moves', single['move to shape']);
  row(design, 'settled', single.settle);
  expect(single.settle.length).toBeGreaterThan(0);
}

/** Until the shape has caught up with the plan, while the button is still down. */
async function idleInDrag(page: Page): Promise<void> {
  await page.waitForFunction(() => ['', 'a drag'].includes(window.lissomTest.busy()), undefined, { timeout: 20_000 });
  await page.waitForTimeout(100);
}

/** Takes hold of a point of the shape, pulls it up, accepts. */
async function pull(page: Page, design: string, point: string): Promise<void> {
  await page.getByRole('tab', { name: 'Shape', exact: true }).click();
  await page.mouse.click(...(await pixelOf(page, point, 'shape')));
  await page.waitForFunction(() => window.lissomTest.pixelOfGrip('z') !== null);
  await idle(page);
  await clear(page);
  const grip = (await page.evaluate(() => window.lissomTest.pixelOfGrip('z'))) as Place;
  await drag(page, grip, [grip[0], grip[1] - 20], { steps: 30, pause: 33 });
  await idle(page);
  row(design, 'linear preview', (await latencies(page)).preview);
  const before = await steps(page);
  const begin = performance.now();
  await page.getByRole('button', { name: /^Accept/ }).click();
  await expect.poll(() => steps(page), { timeout: 60_000, interval: 20 }).toBe(before + 1);
  row(design, 'accepted and fitted', [performance.now() - begin]);
  const fit = (await page.evaluate(() => window.lissomTest.fit())) as { before_mm: number; after_mm: number };
  process.stdout.write(`${design}\tdistance falls to\t${((100 * fit.after_mm) / fit.before_mm).toFixed(1)}\t%\n`);
}

for (const { name, moved, pulled } of designs) {
  test(name, async () => {
    studio = await Studio.start(name);
    const page = await studio.open();
    await page.waitForFunction(() => window.lissomTest.latencies()['first picture'].length > 0);
    row(name, 'first picture', (await latencies(page))['first picture']);
    await edit(page, name, moved);
    await pull(page, name, pulled);
    expect(studio.complaints).toEqual([]);
  });
}
