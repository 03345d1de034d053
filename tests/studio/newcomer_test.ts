// A newcomer's path through the studio, by roles and names, and two tabs that show the same.

import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { drag, idle, pixelOf, Studio } from './studio_browser';

let studio: Studio;
let page: Page;

beforeAll(async () => {
  studio = await Studio.start('butterfly');
  page = await studio.open();
}, 120_000);
afterAll(() => studio.end());

const counts = (of: Page = page) => of.evaluate(() => window.lissomTest.counts());
const verdict = () => page.evaluate(() => window.lissomTest.verdict() as { name: string } | null);
const pointNames = async () =>
  (await page.evaluate(() => (window.lissomTest.plan() as { points: { name: string }[] }).points)).map((point) => point.name);

async function rodThrough(from: string, to: string): Promise<void> {
  const { rods } = await counts();
  await page.keyboard.press('p');
  await page.mouse.click(...(await pixelOf(page, from, 'plan')));
  await page.mouse.click(...(await pixelOf(page, to, 'plan')));
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await expect.poll(async () => (await counts()).rods, { timeout: 20_000 }).toBe(rods + 1);
  await idle(page);
}

test('from a disc by two crossing rods to a file', async () => {
  await page.keyboard.press('Control+o');
  await page.getByRole('button', { name: /^Disc/ }).first().click();
  await expect.poll(async () => (await counts()).rods, { timeout: 20_000 }).toBe(1);
  await idle(page);
  const rim = await pointNames();
  await rodThrough(rim[0], rim[4]);
  await rodThrough(rim[2], rim[6]);
  // They are joined where they cross.
  const { rods } = await page.evaluate(() => window.lissomTest.plan() as { rods: { points: number[] }[] });
  expect(rods[1].points.filter((point) => rods[2].points.includes(point)).length).toBeGreaterThan(0);
  expect((await verdict())?.name).toBe('stable');

  const from = await pixelOf(page, rim[0], 'plan');
  await drag(page, from, [from[0] + 8, from[1] + 3], { steps: 8, pause: 60 });
  await idle(page);
  const dragged = (await counts()).at;

  await page.getByRole('tab', { name: 'Shape', exact: true }).click();
  await page.mouse.click(...(await pixelOf(page, rim[2], 'shape')));
  await page.waitForFunction(() => window.lissomTest.pixelOfGrip('z') !== null);
  await page.keyboard.type('gz3');
  await expect.poll(async () => (await page.evaluate(() => window.lissomTest.latencies())).preview.length, { timeout: 20_000 }).toBeGreaterThan(0);
  await idle(page);
  await page.getByRole('button', { name: /^Accept/ }).click();
  await expect.poll(async () => (await counts()).at, { timeout: 60_000 }).toBe(dragged + 1);
  await idle(page);
  expect((await verdict())?.name).toBe('stable');

  await page.getByRole('tab', { name: 'Make', exact: true }).click();
  await page.getByRole('button', { name: /Write .*\.stl/ }).click();
  await page.getByText(/Written: .*\.stl/).first().waitFor({ timeout: 30_000 });
  expect(studio.complaints).toEqual([]);
});

test('two tabs show the same', async () => {
  const other = await studio.open();
  const plan = (of: Page) => of.evaluate(() => window.lissomTest.plan());
  expect(await plan(other)).toEqual(await plan(page));
  const { at } = await counts();
  await page.bringToFront();
  await page.keyboard.press('Control+z');
  for (const of of [page, other]) await expect.poll(async () => (await counts(of)).at, { timeout: 20_000 }).toBe(at - 1);
  await idle(page);
  await idle(other);
  expect(await plan(other)).toEqual(await plan(page));
  await other.close();
});
