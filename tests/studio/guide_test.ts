// What docs/guide/studio.md tells a newcomer to do, done. With LISSOM_PICTURES=FOLDER its pictures are taken on the way:
//
//     LISSOM_PICTURES=docs/pictures tools/page_tests.py tests/studio/guide_test.ts

import { existsSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { drag, idle, pixelOf, Studio } from './studio_browser';

const root = resolve(import.meta.dirname, '../..');
const pictures = process.env.LISSOM_PICTURES ? resolve(root, process.env.LISSOM_PICTURES) : '';

let studio: Studio;
let page: Page;

beforeAll(async () => {
  studio = await Studio.start('butterfly');
  page = await studio.open();
}, 120_000);
afterAll(() => studio.end());

const counts = () => page.evaluate(() => window.lissomTest.counts());
const tab = (name: string) => page.getByRole('tab', { name, exact: true }).click();
const button = (name: string | RegExp) => page.getByRole('button', { name });

async function picture(name: string): Promise<void> {
  if (pictures === '') return;
  await idle(page);
  await page.mouse.move(400, 18);
  // One picture of the screen after the last change.
  await page.waitForTimeout(1200);
  await page.screenshot({ path: join(pictures, `studio-${name}.png`) });
}

async function steps(wanted: number): Promise<void> {
  await expect.poll(async () => (await counts()).at, { timeout: 60_000 }).toBe(wanted);
  await idle(page);
}

test('Draw shows the butterfly', async () => {
  expect(await counts()).toMatchObject({ points: 50, steps: 0 });
  await picture('draw');
  await page.keyboard.press('?');
  await page.getByRole('dialog', { name: 'Keys' }).waitFor();
  await page.keyboard.press('Escape');
  // The line at the bottom says why.
  await page.getByRole('button', { name: /Settled/ }).click();
  await page.getByRole('dialog', { name: 'Verdict' }).waitFor();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+k');
  await page.getByRole('dialog', { name: 'What do you want to do?' }).waitFor();
  await page.keyboard.press('Escape');
});

test('a mode is explored', async () => {
  await tab('Explore');
  await button('Find 6 modes').click();
  await expect.poll(async () => (await counts()).modes, { timeout: 60_000 }).toBe(6);
  await button(/^Mode 2/).click();
  await picture('explore');
  await button('Hide it').click();
  await tab('Draw');
});

test('the flower: popped up, dragged, pulled, accepted, written', async () => {
  await page.keyboard.press('Control+o');
  await page.getByRole('dialog', { name: 'Begin' }).waitFor();
  await picture('begin');
  await button(/^Flower/).click();
  await expect.poll(async () => (await counts()).rods, { timeout: 20_000 }).toBe(7);
  await idle(page);
  const height = async () => (await page.evaluate(() => window.lissomTest.verdict() as { name: string })).name;
  expect(await height()).toBe('stable');

  const from = await pixelOf(page, 'tip1', 'plan');
  await drag(page, from, [from[0] + 12, from[1] - 6], { steps: 10, pause: 60 });
  await steps(1);
  await page.keyboard.press('Control+z');
  await steps(0);
  await page.keyboard.press('Control+y');
  await steps(1);

  await tab('Shape');
  await page.mouse.click(...(await pixelOf(page, 'tip1', 'shape')));
  await page.waitForFunction(() => window.lissomTest.pixelOfGrip('z') !== null);
  await page.keyboard.press('g');
  await page.keyboard.press('z');
  await page.keyboard.press('4');
  await page.getByRole('heading', { name: 'What will change' }).waitFor();
  await picture('shape');
  await button(/^Accept/).click();
  await steps(2);
  const fit = await page.evaluate(() => window.lissomTest.fit() as { before_mm: number; after_mm: number });
  expect(fit.after_mm).toBeLessThan(fit.before_mm);
  await button('Revert').click();
  await steps(1);
  await page.keyboard.press('Control+y');
  await steps(2);

  await tab('Make');
  await button('Write flower.stl').click();
  await page.getByText(/Written: flower\.stl/).first().waitFor({ timeout: 30_000 });
  await picture('make');
  expect(statSync(join(studio.folder, 'flower.stl')).size).toBeGreaterThan(100_000);
  for (const format of ['svg', 'dxf']) {
    await button(`Write flower.${format}`).click();
    await expect.poll(() => existsSync(join(studio.folder, `flower.${format}`)), { timeout: 20_000 }).toBe(true);
  }
  expect(studio.complaints).toEqual([]);
});
