// Every state of the panels in a real browser against a running studio: no fault of axe, no error in the console, nothing
// wider than the page. Finds everything by role and name.
//
//   node tests/browser/panel_states.mjs ADDRESS [FOLDER FOR PICTURES]
//
// ADDRESS is what `lissom studio disc-crossed --no-browser` prints. Ends with "N passed, M failed".

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { chromium } from 'playwright-core';

const [address, pictures] = process.argv.slice(2);
if (!address) {
  console.error('say the address that lissom studio has printed');
  process.exit(2);
}
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
let passed = 0;
let failed = 0;

/** Does a command by its title, as people do: search, Enter. */
async function command(page, title) {
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Search commands' }).fill(title);
  await page.getByRole('option', { name: title }).first().waitFor();
  await page.keyboard.press('Enter');
}

const idle = (page, milliseconds = 60000) => page.evaluate((most) => window.lissomTest.whenIdle(most), milliseconds);
const escape = (page) => page.keyboard.press('Escape');
const mode = (page, name) => page.getByRole('tab', { name }).click();
const button = (page, name) => page.getByRole('button', { name });
const row = (page, name) => page.getByRole('treeitem', { name });

async function enter(page, name, text) {
  const field = page.getByRole('spinbutton', { name });
  await field.fill(text);
  await field.press('Enter');
}

/** In order; each goes on from where the one before has left the page. */
const states = [
  ['as opened', () => {}],
  ['menu', async (page) => {
    await page.getByRole('button', { name: 'lissom', exact: true }).click();
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('ArrowRight');
  }, escape],
  ['file menu', async (page) => page.getByRole('button', { name: /disc/ }).first().click(), escape],
  ['look and navigation', async (page) => button(page, 'Look and navigation').click(), escape],
  ['what the view shows', async (page) => button(page, 'What the view shows').click(), escape],
  ['snapping', async (page) => button(page, 'Snapping').click(), escape],
  ['command search', async (page) => {
    await page.keyboard.press('Control+k');
    await page.keyboard.type('plan');
  }, escape],
  ['nothing found', async (page) => {
    await page.keyboard.press('Control+k');
    await page.keyboard.type('zzzz');
  }, escape],
  ['keys', (page) => command(page, 'Keys'), escape],
  ['start', async (page) => {
    await command(page, 'New or open');
    await page.getByRole('button', { name: /Butterfly/ }).waitFor();
  }, escape],
  ['save as', (page) => command(page, 'Save as'), escape],
  ['about', (page) => command(page, 'About lissom'), escape],
  ['way round', (page) => command(page, 'Show me around'), async (page) => button(page, 'End the way round').click()],
  ['verdict', (page) => command(page, 'Say why, and what to do'), escape],
  ['rod', async (page) => {
    await mode(page, 'Draw');
    await page.getByRole('treeitem', { level: 2 }).first().click();
  }],
  ['points, mixed', async (page) => {
    await row(page, /^Points/).dblclick();
    const points = page.getByRole('treeitem', { level: 2, name: /mm$/ });
    const last = await points.count();
    await points.nth(last - 1).click();
    await points.nth(last - 2).click({ modifiers: ['Shift'] });
    await points.nth(last - 3).click({ modifiers: ['Shift'] });
  }],
  ['pinned and in a plane', async (page) => {
    await button(page, 'Keep in a plane').first().click();
    await page.getByRole('checkbox', { name: 'Pinned' }).click();
    await idle(page);
  }],
  ['point', async (page) => page.getByRole('treeitem', { level: 2, name: /mm$/ }).last().click()],
  ['text refused', (page) => enter(page, 'x, mm', 'wide'), escape],
  ['value refused', async (page) => {
    await enter(page, 'Radius in plane, mm', '-1');
    await page.getByRole('alert').first().waitFor();
  }, escape],
  ['legend opened', async (page) => page.getByRole('button', { name: /^Rods: / }).click()],
  ['plan beside', async (page) => button(page, 'Plan beside the shape').click()],
  ['plan alone', async (page) => button(page, 'Plan alone').click()],
  ['shape alone', async (page) => button(page, 'Hide the plan').click(), async (page) => page.getByRole('button', { name: 'Plan', exact: true }).click()],
  ['explore', (page) => mode(page, 'Explore')],
  ['modes', async (page) => {
    await button(page, /^Find/).first().click();
    await idle(page);
    await button(page, /^Mode 1/).click();
  }, async (page) => button(page, 'Hide it').click()],
  ['shape', (page) => mode(page, 'Shape')],
  ['pulled', async (page) => {
    await page.getByRole('spinbutton', { name: 'Move along z, mm' }).waitFor();
    await enter(page, 'Move along z, mm', '2 mm');
    await page.getByRole('list', { name: 'What will change most' }).waitFor();
  }],
  ['let go', async (page) => button(page, 'Cancel').click()],
  ['held still', async (page) => {
    await button(page, 'Hold still').click();
    await page.getByText(/parts? stays?/).waitFor();
  }, async (page) => button(page, 'Let all go').click()],
  ['make', (page) => mode(page, 'Make')],
  ['written', async (page) => {
    await button(page, /^Write .*svg/).click();
    await page.getByRole('tabpanel').getByText(/^Written/).waitFor();
  }],
  ['narrow', async (page) => page.setViewportSize({ width: 720, height: 450 })],
  ['narrow, inspector', async (page) => button(page, 'Show the inspector').click()],
  ['narrow, tree', async (page) => button(page, 'Show the tree').click(), async (page) => page.setViewportSize({ width: 1100, height: 700 })],
  ['large interface', (page) => command(page, 'Interface at 200 %'), (page) => command(page, 'Interface at 100 %')],
];

async function check(page, name, faults) {
  const client = await page.context().newCDPSession(page);
  await client.send('Runtime.evaluate', { expression: axe });
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
  for (const { id, help, nodes } of violations) faults.push(`${id}: ${help} (${nodes.map((n) => n.target.join(' ')).join(', ')})`);
  const [wide, room] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  if (wide > room) faults.push(`the page is ${wide} pixels wide in a window of ${room}`);
  if (pictures) await page.screenshot({ path: `${pictures}/${name.replace(/[^a-z]+/g, '-')}.png` });
  await client.detach();
}

async function state(page, theme, [name, come, leave], faults) {
  try {
    await come(page);
    await page.waitForTimeout(300);
    await check(page, `${theme} ${name}`, faults);
    await leave?.(page);
  } catch (error) {
    faults.push(String(error).split('\n')[0]);
    if (pictures) await page.screenshot({ path: `${pictures}/failed-${theme}-${name.replace(/[^a-z]+/g, '-')}.png` });
  }
  if (faults.length === 0) ++passed;
  else ++failed;
  console.log(`${faults.length === 0 ? 'ok' : 'FAIL'} ${theme}, ${name}${faults.map((f) => `\n     ${f}`).join('')}`);
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce' });
const page = await context.newPage();
let faults = [];
page.on('console', (message) => {
  if (message.type() === 'error') faults.push(`console: ${message.text()}`);
});
page.on('pageerror', (error) => faults.push(`page: ${error.message}`));
await page.goto(address);
for (const theme of ['light', 'dark']) {
  await page.emulateMedia({ colorScheme: theme, reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.evaluate(() => localStorage.clear());
  await page.goto(address.replace(/\?.*/, ''));
  await idle(page);
  for (const one of states) {
    faults = [];
    await state(page, theme, one, faults);
  }
}
await browser.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
