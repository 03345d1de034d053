// Runs `lissom studio` in a folder of its own and opens its page in Chromium. Tests find things as people do, by roles and
// names; numbers come from window.lissomTest (apps/studio/page/src/test_hook.ts).

import { spawn, type ChildProcess } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { delimiter, join, resolve } from 'node:path';
import { chromium, type Browser, type BrowserContext, type Page } from 'playwright-core';
import type { LissomTest } from '../../apps/studio/page/src/test_hook';

declare global {
  interface Window {
    lissomTest: LissomTest;
  }
}

const root = resolve(import.meta.dirname, '../..');
const tool = process.env.LISSOM_CLI ?? join(root, 'build/release/lissom');
/** A built page to use instead of the one in the tool, while working on the page. */
const otherPage = process.env.LISSOM_STUDIO_PAGE ?? '';

// As on a machine without a graphics card: the browser puts its pages together by itself, and SwiftShader draws WebGL alone.
// (With --use-angle=swiftshader it would put pages together through SwiftShader, too, which takes three times as long.)
const flags = ['--no-sandbox', '--enable-unsafe-swiftshader'];
// A page that comes from elsewhere than the server has no network of its own, and may not reach the loopback.
if (otherPage !== '') flags.push('--disable-features=LocalNetworkAccessChecks');

function browserPath(): string {
  const names = ['chromium', 'chromium-browser', 'google-chrome'];
  const places = (process.env.PATH ?? '').split(delimiter).flatMap((folder) => names.map((name) => join(folder, name)));
  const found = places.find((place) => existsSync(place));
  if (!found) throw new Error('no browser on PATH');
  return found;
}

/** One that nobody listens at, below those that the system gives to clients: it has to be had again after a kill. */
async function freePort(): Promise<number> {
  for (;;) {
    const port = 20000 + Math.floor(Math.random() * 12000);
    const free = await new Promise<boolean>((done) => {
      const probe = createServer();
      probe.once('error', () => done(false));
      probe.listen(port, '127.0.0.1', () => probe.close(() => done(true)));
    });
    if (free) return port;
  }
}

export class Studio {
  /** What the page has said that it should not have: messages of the console at level error, exceptions. */
  readonly complaints: string[] = [];
  /** Bytes that came over the wire for the page, by file. */
  readonly bytes = new Map<string, number>();
  readonly folder = mkdtempSync(join(tmpdir(), 'lissom-studio-'));
  private server!: ChildProcess;
  private browser!: Browser;
  private context!: BrowserContext;
  private port = 0;
  private address = '';
  private entered = false;

  private constructor(private readonly design: string) {}

  static async start(design: string): Promise<Studio> {
    const studio = new Studio(design);
    const address = await studio.serve(await freePort());
    studio.browser = await chromium.launch({ executablePath: browserPath(), args: flags });
    studio.context = await studio.browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce' });
    if (otherPage !== '') await studio.replacePage(address);
    return studio;
  }

  /** Another tab; the first one comes with the address that lets the browser in. */
  async open(): Promise<Page> {
    const page = await this.context.newPage();
    page.on('console', (message) => message.type() === 'error' && this.complaints.push(message.text()));
    page.on('pageerror', (fault) => this.complaints.push(fault.message));
    page.on('response', async (response) => {
      const sizes = await response.request().sizes().catch(() => null);
      if (sizes) this.bytes.set(new URL(response.url()).pathname, sizes.responseBodySize);
    });
    await page.goto(this.entered ? `http://127.0.0.1:${this.port}/` : this.address);
    this.entered = true;
    await idle(page);
    return page;
  }

  /** Number of the server's process. */
  get process(): number {
    return this.server.pid ?? 0;
  }

  /** As if the machine had lost it. */
  async kill(): Promise<void> {
    const ended = new Promise((done) => this.server.once('exit', done));
    this.server.kill('SIGKILL');
    await ended;
  }

  /** The same studio once more, on the same port. */
  async again(): Promise<void> {
    await this.serve(this.port);
  }

  async end(): Promise<void> {
    await this.browser?.close();
    if (this.server.exitCode === null && this.server.signalCode === null) await this.kill();
    rmSync(this.folder, { recursive: true, force: true });
  }

  private async serve(port: number): Promise<string> {
    // A private folder for what the studio keeps, so that it neither finds nor leaves anything of the user's.
    const env = { ...process.env, XDG_RUNTIME_DIR: this.folder, XDG_STATE_HOME: join(this.folder, 'state') };
    const words = ['studio', this.design, '--folder', this.folder, '--no-browser', '--port', String(port)];
    this.server = spawn(tool, words, { env, stdio: ['ignore', 'pipe', 'pipe'] });
    this.port = port;
    let said = '';
    this.address = await new Promise<string>((done, refuse) => {
      const hear = (text: Buffer) => {
        said += text.toString();
        const found = /http:\/\/\S+token=\S+/.exec(said);
        if (found) done(found[0]);
      };
      this.server.stdout?.on('data', hear);
      this.server.stderr?.on('data', hear);
      this.server.once('exit', () => refuse(new Error(`the studio ended: ${said}`)));
    });
    return this.address;
  }

  private async replacePage(address: string): Promise<void> {
    const first = await this.context.newPage();
    await first.goto(address);
    await first.close();
    this.entered = true;
    const types: Record<string, string> = { js: 'text/javascript', css: 'text/css', html: 'text/html', svg: 'image/svg+xml' };
    await this.context.route(`http://127.0.0.1:${this.port}/**`, (route) => {
      const path = new URL(route.request().url()).pathname;
      const file = join(otherPage, path === '/' ? 'index.html' : path);
      if (!existsSync(file)) return route.continue();
      const contentType = types[file.split('.').pop() ?? ''] ?? 'text/plain';
      return route.fulfill({ body: readFileSync(file), headers: { 'content-type': contentType, 'content-security-policy': "default-src 'self'" } });
    });
  }
}

/** Waits until nothing is under way in the page. */
export async function idle(page: Page): Promise<void> {
  await page.waitForFunction(() => window.lissomTest !== undefined);
  await page.evaluate(() => window.lissomTest.whenIdle(60000));
}

export type Place = [number, number];

/** Where a control point is on the page. */
export async function pixelOf(page: Page, point: string, where: 'plan' | 'shape'): Promise<Place> {
  const found = await page.evaluate(([p, w]) => window.lissomTest.pixelOf(p, w as 'plan'), [point, where]);
  if (!found) throw new Error(`point ${point} is not to be seen`);
  return found;
}

/** Presses at one place, goes to another in steps, one every `pause` ms, and lets go (unless told to hold). */
export async function drag(page: Page, from: Place, to: Place, options: { steps?: number; pause?: number; hold?: boolean; button?: 'left' | 'right' } = {}): Promise<void> {
  const { steps = 10, pause = 30, hold = false, button = 'left' } = options;
  await page.mouse.move(...from);
  await page.mouse.down({ button });
  for (let i = 1; i <= steps; ++i) {
    await page.mouse.move(from[0] + ((to[0] - from[0]) * i) / steps, from[1] + ((to[1] - from[1]) * i) / steps);
    await page.waitForTimeout(pause);
  }
  if (!hold) await page.mouse.up({ button });
}

export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}
