// Takes a picture of the page: node dev/shot.mjs OUT.png [URL] [STEPS.mjs]; STEPS exports a function of playwright's page.

import { chromium } from 'playwright-core';

const [out, url = 'http://127.0.0.1:5173/', steps] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
page.on('console', (message) => console.log('console', message.type(), message.text()));
page.on('pageerror', (fault) => console.log('page error', fault.message));
await page.goto(url);
await page.waitForTimeout(Number(process.env.WAIT ?? 2500));
if (steps) await (await import(new URL(steps, `file://${process.cwd()}/`).href)).default(page);
await page.screenshot({ path: out });
await browser.close();
