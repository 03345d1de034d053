// Scripted editing for a while: the memory of page and server must not grow, nothing may complain, no job may hang.
//
//     tools/page_tests.py tests/studio/soak_test.ts                        20 s, as in `make test`: only that it works
//     LISSOM_SOAK_S=600 tools/page_tests.py tests/studio/soak_test.ts      ten minutes, with the limits of memory
//
// One round: a new design, edits of all kinds, all undone and done again, modes, a pull that is accepted, files, looks. Memory
// is read at the end of each, with the same design in the same state.

import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { CDPSession, Page } from 'playwright-core';
import { RandomEdits } from './random_edits';
import { stepOf } from './random_hands';
import { idle, median, pixelOf, Studio } from './studio_browser';

const seconds = Number(process.env.LISSOM_SOAK_S ?? 20);
/** Rounds before memory is compared, or a third of them: the browser compiles more and more of the code that runs, which is all
 *  that grows in the page then (0.4 MB from the 14th to the 30th round, 2026-12-01, by heap snapshots). */
const leastWarmUp = 8;
const mostGrowth = 0.05;
const editsOfRound = 8;

let studio: Studio;
let page: Page;
let probe: CDPSession;

beforeAll(async () => {
  studio = await Studio.start('butterfly');
  page = await studio.open();
  probe = await page.context().newCDPSession(page);
  await probe.send('Performance.enable');
}, 120_000);
afterAll(() => studio.end());

interface Memory {
  /** MB: objects and buffers of the page after a collection of garbage. */
  page: number;
  /** MB: resident memory of the server. */
  server: number;
  nodes: number;
  listeners: number;
}

async function memory(): Promise<Memory> {
  for (let i = 0; i < 2; ++i) await probe.send('HeapProfiler.collectGarbage');
  const { usedSize, backingStorageSize = 0 } = (await probe.send('Runtime.getHeapUsage')) as { usedSize: number; backingStorageSize?: number };
  const { metrics } = await probe.send('Performance.getMetrics');
  const metric = (name: string) => metrics.find((m) => m.name === name)?.value ?? NaN;
  const resident = /VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${studio.process}/status`, 'utf8'));
  return { page: (usedSize + backingStorageSize) / 1e6, server: Number(resident?.[1]) / 1e3, nodes: metric('Nodes'), listeners: metric('JSEventListeners') };
}

const button = (name: string | RegExp) => page.getByRole('button', { name });
const tab = (name: string) => page.getByRole('tab', { name, exact: true }).click();

async function begin(template: string): Promise<void> {
  await page.keyboard.press('Control+o');
  await button(new RegExp(`^${template}`)).first().click();
  // What is not saved is asked about first.
  const drop = button('Go on without saving');
  await page.waitForFunction(() => window.lissomTest.counts().steps === 0 || [...document.querySelectorAll('dialog:modal')].some((d) => d.textContent?.includes('Go on without saving')));
  if (await drop.isVisible()) await drop.click();
  await page.waitForFunction(() => window.lissomTest.counts().steps === 0);
  await idle(page);
}

async function undoAndRedo(): Promise<void> {
  const last = await stepOf(page);
  for (const [key, end] of [['Control+z', 0], ['Control+y', last]] as const) {
    for (let i = 0; i < last; ++i) await page.keyboard.press(key);
    await page.waitForFunction((at) => window.lissomTest.counts().at === at, end, { timeout: 60_000 });
    await idle(page);
  }
}

async function explore(): Promise<void> {
  await tab('Explore');
  await button(/^Find/).first().click();
  await page.waitForFunction(() => window.lissomTest.counts().modes > 0, undefined, { timeout: 60_000 });
  await button(/^Mode 1/).click();
  await page.waitForTimeout(300);
  await button('Hide it').click();
}

async function pull(point: string): Promise<void> {
  await tab('Shape');
  await page.mouse.click(...(await pixelOf(page, point, 'shape')));
  await page.waitForFunction(() => window.lissomTest.pixelOfGrip('z') !== null);
  await page.keyboard.type('gz2');
  const before = await stepOf(page);
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await page.waitForFunction((at) => window.lissomTest.counts().at > at, before, { timeout: 120_000 });
  await idle(page);
}

async function look(): Promise<void> {
  for (const key of ['7', '1', '3', '5', '5', 'Home', 'h', 'h']) await page.keyboard.press(key);
  for (const name of ['Plan beside the shape', 'Plan alone', 'Plan below the shape']) await button(name).first().click();
}

async function round(edits: RandomEdits): Promise<void> {
  await tab('Draw');
  for (let i = 0; i < editsOfRound; ++i) await edits.next();
  await idle(page);
  await undoAndRedo();
  await look();
  await tab('Draw');
  await begin('Disc');
  await explore();
  await pull('rim3');
  await tab('Make');
  await button(/Write .*\.svg/).click();
  await page.getByText(/Written: .*\.svg/).first().waitFor();
  await page.keyboard.press('Escape');
  await tab('Draw');
  await begin('Flower');
}

test(`${seconds} s of editing`, { timeout: (seconds + 300) * 1000 }, async () => {
  await begin('Flower');
  await page.getByRole('heading', { name: 'Constraints' }).click();
  const edits = new RandomEdits(page, 11);
  const end = Date.now() + 1000 * seconds;
  const seen: Memory[] = [];
  while (Date.now() < end || seen.length === 0) {
    await round(edits);
    const now = await memory();
    seen.push(now);
    console.log(`round ${seen.length}: page ${now.page.toFixed(2)} MB, server ${now.server.toFixed(1)} MB, ${now.nodes} nodes, ${now.listeners} listeners`);
    expect(studio.complaints).toEqual([]);
  }
  if (seen.length < 2 * leastWarmUp) return;
  const warmUp = Math.max(leastWarmUp, Math.floor(seen.length / 3));
  const third = Math.ceil((seen.length - warmUp) / 3);
  const [before, after] = [seen.slice(warmUp, warmUp + third), seen.slice(-third)];
  for (const what of ['page', 'server', 'nodes', 'listeners'] as const) {
    const growth = median(after.map((m) => m[what])) / median(before.map((m) => m[what])) - 1;
    console.log(`${what}: ${(100 * growth).toFixed(1)} % more at the end`);
    expect(growth, what).toBeLessThan(mostGrowth);
  }
});
