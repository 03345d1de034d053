// What a person's hands do in the page, at random places: point, click, type, press, choose. The same seed does the same.

import type { Locator, Page } from 'playwright-core';
import { pixelOf, type Place } from './studio_browser';

export interface Point {
  name: string;
  at_mm: Place;
}

export interface Rod {
  name: string;
  points: number[];
  closed: boolean;
}

export interface Plan {
  points: Point[];
  rods: Rod[];
  fabric: { holes_mm: Place[] };
}

/** Mulberry32. */
export function randomNumbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

export class RandomHands {
  readonly random: () => number;
  private names = 0;

  constructor(
    readonly page: Page,
    seed: number,
  ) {
    this.random = randomNumbers(seed);
  }

  below(count: number): number {
    return Math.floor(this.random() * count);
  }

  between(low: number, high: number, digits = 2): string {
    return (low + (high - low) * this.random()).toFixed(digits);
  }

  pick<T>(of: readonly T[]): T {
    return of[this.below(of.length)];
  }

  shuffled<T>(of: readonly T[]): T[] {
    const out = [...of];
    for (let i = out.length - 1; i > 0; --i) {
      const k = this.below(i + 1);
      [out[i], out[k]] = [out[k], out[i]];
    }
    return out;
  }

  freshName(): string {
    return `n${++this.names}`;
  }

  plan(): Promise<Plan> {
    return this.page.evaluate(() => {
      const { points, rods, fabric } = window.lissomTest.plan() as Plan;
      return {
        points: points.map(({ name, at_mm }) => ({ name, at_mm })),
        rods: rods.map(({ name, points: through, closed }) => ({ name, points: through, closed })),
        fabric: { holes_mm: fabric.holes_mm },
      };
    });
  }

  /** The drawn line of a rod; of all: places here and there on them. */
  lines(rod?: string): Promise<Place[]> {
    return this.page.evaluate((name) => {
      const { rods } = window.lissomTest.plan() as { rods: { name: string; line_mm: Place[] }[] };
      if (name !== undefined) return rods.find((r) => r.name === name)?.line_mm ?? [];
      return rods.flatMap((r) => r.line_mm.filter((_, i) => i % 4 === 0));
    }, rod);
  }

  /** A point's place on the page. */
  async point(): Promise<Place> {
    const { points } = await this.plan();
    return pixelOf(this.page, this.pick(points).name, 'plan');
  }

  /** A place on a rod, away from its points. */
  async onRod(which: (rod: Rod) => boolean = () => true): Promise<Place> {
    const { points, rods } = await this.plan();
    const line = await this.lines(this.pick(rods.some(which) ? rods.filter(which) : rods).name);
    const away = (at: Place) => Math.min(...points.map((p) => Math.hypot(p.at_mm[0] - at[0], p.at_mm[1] - at[1])));
    const [best] = line.slice(0, -1).map((a, i): Place => [(a[0] + line[i + 1][0]) / 2, (a[1] + line[i + 1][1]) / 2]).sort((a, b) => away(b) - away(a));
    return this.pixel(best);
  }

  /** Somewhere between the rods. */
  async somewhere(): Promise<Place> {
    const { points } = await this.plan();
    const [a, b, c] = [this.pick(points), this.pick(points), this.pick(points)].map((p) => p.at_mm);
    return this.pixel([0.5 * a[0] + 0.3 * b[0] + 0.2 * c[0], 0.5 * a[1] + 0.3 * b[1] + 0.2 * c[1]]);
  }

  /** Of some such places the one that is furthest from all rods. */
  async free(): Promise<Place> {
    const { points } = await this.plan();
    const lines = await this.lines();
    const away = ([x, y]: Place) => Math.min(...lines.map((p) => Math.hypot(p[0] - x, p[1] - y)));
    const [best] = Array.from({ length: 20 }, (): Place => {
      const [a, b, c] = [this.pick(points), this.pick(points), this.pick(points)].map((p) => p.at_mm);
      return [(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3];
    }).sort((a, b) => away(b) - away(a));
    return this.pixel(best);
  }

  async pixel(at: Place): Promise<Place> {
    const found = await this.page.evaluate((place) => window.lissomTest.pixelInPlan(place), at);
    if (!found) throw new Error('the plan is not to be seen');
    return found;
  }

  click(place: Place): Promise<void> {
    return this.page.mouse.click(...place);
  }

  async selectPoints(count: number): Promise<void> {
    for (let i = 0; i < count; ++i) {
      if (i === 1) await this.page.keyboard.down('Shift');
      await this.click(await this.point());
    }
    if (count > 1) await this.page.keyboard.up('Shift');
  }

  async selectRod(which?: (rod: Rod) => boolean): Promise<void> {
    await this.click(await this.onRod(which));
  }

  section(title: string | RegExp): Locator {
    return this.page.getByRole('group').filter({ has: this.page.getByRole('heading', { name: title, exact: true }) });
  }

  /** Types a value; a field that is not there is a turn without an edit. */
  async type(field: Locator, value: string): Promise<void> {
    if ((await field.count()) === 0) return;
    await field.first().fill(value);
    await field.first().press('Enter');
  }

  async press(button: Locator): Promise<void> {
    if ((await button.count()) > 0 && (await button.first().isEnabled())) await button.first().click();
  }

  async choose(list: Locator): Promise<void> {
    if ((await list.count()) === 0) return;
    const others = await list.first().locator('option:not(:checked):enabled').allTextContents();
    if (others.length > 0) await list.first().selectOption({ label: this.pick(others) });
  }

  async withTool(key: string, ...places: (() => Promise<Place>)[]): Promise<void> {
    await this.page.keyboard.press(key);
    for (const place of places) await this.click(await place());
  }
}

export function stepOf(page: Page): Promise<number> {
  return page.evaluate(() => window.lissomTest.counts().at);
}
