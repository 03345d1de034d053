// Random edits of every kind that the page offers, back to the first byte of the document, and forward again to the last.
// LISSOM_EDITS and LISSOM_SEED ask for more of them, or others.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { editKinds, RandomEdits, type EditKind } from './random_edits';
import { stepOf } from './random_hands';
import { Studio } from './studio_browser';

const wanted = Number(process.env.LISSOM_EDITS ?? 200);
const seed = Number(process.env.LISSOM_SEED ?? 6);
const file = 'walk.lissom';

let studio: Studio;
let page: Page;

beforeAll(async () => {
  studio = await Studio.start('butterfly');
  page = await studio.open();
}, 120_000);
afterAll(() => studio.end());

/** A digest of the plan as the page has it, but for the number that every change raises. */
const shown = () =>
  page.evaluate(async () => {
    const plan = JSON.stringify({ ...(window.lissomTest.plan() as object), revision: 0 });
    return new Uint8Array(await crypto.subtle.digest('SHA-256', new TextEncoder().encode(plan))).join(' ');
  });

async function save(): Promise<string> {
  await page.keyboard.press('Control+s');
  await page.waitForFunction(() => {
    const { at, saved_at } = window.lissomTest.history() as { at: number; saved_at: number };
    return at === saved_at;
  });
  return readFileSync(join(studio.folder, file), 'utf8');
}

async function step(key: string, to: number): Promise<void> {
  await page.keyboard.press(key);
  await page.waitForFunction((at) => window.lissomTest.counts().at === at && window.lissomTest.busy() === '', to, { polling: 20, timeout: 20_000 });
}

test(`${wanted} random edits are undone and done again to the byte`, { timeout: 600_000 }, async () => {
  await page.setViewportSize({ width: 1100, height: 700 });
  await page.getByRole('group', { name: 'Place of the plan' }).getByRole('button', { name: 'Plan alone' }).click();
  await page.getByRole('button', { name: 'Live' }).click();
  await page.getByRole('button', { name: 'On hold' }).waitFor();
  await page.getByRole('heading', { name: 'Constraints' }).click();
  await page.keyboard.press('Control+Shift+s');
  await page.getByRole('textbox', { name: /^Name of the file/ }).fill(file);
  await page.keyboard.press('Enter');
  await page.getByRole('dialog', { name: 'Save as' }).waitFor({ state: 'hidden' });

  const edits = new RandomEdits(page, seed);
  const plans = [await shown()];
  const bytes = new Map([[0, await save()]]);
  const taken = new Map<EditKind, number>();
  const began = Date.now();
  for (let tries = 0; plans.length <= wanted; ++tries) {
    if (tries > 3 * wanted) throw new Error(`only ${plans.length - 1} of ${tries} edits were taken`);
    const { kind, taken: done } = await edits.next();
    const at = await stepOf(page);
    expect(at, kind).toBe(plans.length - 1 + Number(done));
    if (!done) continue;
    taken.set(kind, (taken.get(kind) ?? 0) + 1);
    plans.push(await shown());
    if (at % 50 === 0 || at === wanted) bytes.set(at, await save());
  }
  console.log(`${wanted} edits in ${((Date.now() - began) / 1000).toFixed(0)} s; never taken: ${editKinds.filter((kind) => !taken.has(kind)).join(', ') || 'none'}`);
  if (wanted >= 200) expect(editKinds.filter((kind) => !taken.has(kind))).toEqual([]);

  for (const [key, way] of [['Control+z', -1], ['Control+y', 1]] as const) {
    for (let i = 1; i <= wanted; ++i) {
      const at = way < 0 ? wanted - i : i;
      await step(key, at);
      expect(await shown(), `step ${at}`).toBe(plans[at]);
      if (bytes.has(at)) expect(await save(), `bytes of step ${at}`).toBe(bytes.get(at));
    }
  }
  expect(studio.complaints).toEqual([]);
});
