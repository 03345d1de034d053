// Edits of all kinds that the page offers, each made at a random place as a person makes it: by pointer in the plan, by keys,
// by fields, buttons and lists of the inspector. The same seed makes the same edits.

import type { Locator, Page } from 'playwright-core';
import { pixelOf, type Place } from './studio_browser';

interface Point {
  name: string;
  at_mm: Place;
}

interface Rod {
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

export type EditKind = keyof typeof kinds;

export class RandomEdits {
  readonly random: () => number;
  private deck: EditKind[] = [];
  private names = 0;

  constructor(
    readonly page: Page,
    seed: number,
  ) {
    this.random = randomNumbers(seed);
  }

  /** Tries one edit; says which, and whether it became a step. Every kind has its turn before one comes again. */
  async next(): Promise<{ kind: EditKind; taken: boolean }> {
    if (this.deck.length === 0) this.deck = this.shuffled(Object.keys(kinds) as EditKind[]);
    const kind = this.deck.pop() ?? 'move';
    return { kind, taken: await this.make(kind) };
  }

  private async make(kind: EditKind): Promise<boolean> {
    const { page } = this;
    const at = await stepOf(page);
    await kinds[kind](this);
    const taken = await this.outcome(at);
    // What was refused says so until it is put away; a tool gives way to selecting, then nothing is selected.
    const dismiss = page.getByRole('button', { name: 'Dismiss' });
    if (await dismiss.isVisible()) await dismiss.click();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('Escape');
    await this.leaveField();
    return taken;
  }

  /** Waits until there is another step, or a word why not; an edit that changes nothing says neither. */
  private async outcome(at: number): Promise<boolean> {
    const { page } = this;
    const answered = (before: number) => {
      const hook = window.lissomTest;
      const refused = hook.fault() !== null || document.querySelector('.field-problem') !== null;
      return hook.busy() === '' && (hook.counts().at !== before || refused);
    };
    await page.waitForFunction(answered, at, { timeout: 1000, polling: 20 }).catch(() => undefined);
    return (await stepOf(page)) !== at;
  }

  /** Keys mean the design again, not a field. */
  private leaveField(): Promise<void> {
    return this.page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
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

const spin = (on: RandomEdits, name: string | RegExp) => on.page.getByRole('spinbutton', { name });
const button = (on: RandomEdits, name: string | RegExp) => on.page.getByRole('button', { name, exact: true });
const constraints = (on: RandomEdits) => on.section('Constraints');

async function dragged(on: RandomEdits, from: Place): Promise<void> {
  const { mouse } = on.page;
  const to = [from[0] + on.below(31) - 15, from[1] + on.below(31) - 15] as Place;
  await mouse.move(...from);
  await mouse.down();
  await mouse.move(...to, { steps: 4 });
  await mouse.up();
}

async function drawn(on: RandomEdits, key: string, places: (() => Promise<Place>)[]): Promise<void> {
  await on.withTool(key, ...places);
  await on.page.keyboard.press('Enter');
}

const kinds = {
  move: async (on: RandomEdits) => dragged(on, await on.point()),
  'move a rod': async (on: RandomEdits) => dragged(on, await on.onRod()),
  nudge: async (on: RandomEdits) => {
    await on.selectPoints(1 + on.below(3));
    await on.page.keyboard.press(on.pick(['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown']));
  },
  place: async (on: RandomEdits) => {
    await on.selectPoints(1);
    const field = on.page.getByRole('spinbutton', { name: on.pick(['x, mm', 'y, mm']), exact: true });
    if ((await field.count()) > 0) await on.type(field, String(Number(await field.first().inputValue()) + Number(on.between(-3, 3))));
  },
  'radius in plane': async (on: RandomEdits) => {
    await on.selectPoints(1 + on.below(2));
    await on.type(spin(on, 'Radius in plane, mm'), on.between(0.6, 1.2));
  },
  'radius out of plane': async (on: RandomEdits) => {
    await on.selectRod();
    await on.type(spin(on, 'Radius out of plane, mm'), on.between(0.3, 0.8));
  },
  'radius by slider': async (on: RandomEdits) => {
    await on.selectPoints(1);
    const slider = on.page.getByRole('slider', { name: /^Radius in plane/ });
    if ((await slider.count()) === 0) return;
    for (let i = 0; i < 2; ++i) await slider.press('ArrowRight');
  },
  'scale radii': async (on: RandomEdits) => {
    await on.selectRod();
    await on.type(spin(on, 'Scale radii to, %'), on.between(90, 112, 0));
  },
  'thicken or thin': async (on: RandomEdits) => {
    await on.selectPoints(2);
    await on.page.keyboard.press(on.pick([']', '[']));
  },
  kink: async (on: RandomEdits) => on.withTool('k', () => on.point()),
  'kink by switch': async (on: RandomEdits) => {
    await on.selectPoints(1);
    await on.press(on.page.getByRole('checkbox', { name: 'Kink' }));
  },
  insert: async (on: RandomEdits) => on.withTool('i', () => on.onRod()),
  cut: async (on: RandomEdits) => on.withTool('c', () => on.onRod()),
  'cut at a point': async (on: RandomEdits) => on.withTool('c', () => on.point()),
  rod: async (on: RandomEdits) => drawn(on, 'p', [() => on.point(), () => on.point()]),
  'rod from rod to rod': async (on: RandomEdits) => drawn(on, 'p', [() => on.onRod(), () => on.onRod()]),
  'ghost rod': async (on: RandomEdits) => drawn(on, 'Shift+P', [() => on.point(), () => on.point()]),
  ring: async (on: RandomEdits) => {
    await on.page.keyboard.press('o');
    const { mouse } = on.page;
    const middle = await on.free();
    await mouse.move(...middle);
    await mouse.down();
    await mouse.move(middle[0] + 10 + on.below(8), middle[1], { steps: 3 });
    await mouse.up();
  },
  ghost: async (on: RandomEdits) => on.withTool('Shift+G', () => on.onRod()),
  'ghost by switch': async (on: RandomEdits) => {
    await on.selectRod();
    await on.press(on.page.getByRole('checkbox', { name: 'Ghost' }));
  },
  closed: async (on: RandomEdits) => {
    await on.selectRod((rod) => rod.points.length > 2);
    await on.press(on.page.getByRole('checkbox', { name: 'Closed' }));
  },
  curve: async (on: RandomEdits) => {
    await on.selectRod((rod) => rod.points.length > 2);
    await on.choose(on.page.getByRole('combobox', { name: 'Curve' }));
  },
  erase: async (on: RandomEdits) => on.withTool('e', () => on.onRod()),
  'delete a point': async (on: RandomEdits) => {
    await on.selectPoints(1);
    await on.page.keyboard.press('Delete');
  },
  mirror: async (on: RandomEdits) => {
    await on.selectRod();
    await on.press(button(on, on.pick(['Mirror x', 'Mirror y'])));
  },
  merge: async (on: RandomEdits) => {
    const { points } = await on.plan();
    const first = on.pick(points);
    const far = (p: Point) => Math.hypot(p.at_mm[0] - first.at_mm[0], p.at_mm[1] - first.at_mm[1]);
    const [second] = points.filter((p) => p !== first).sort((a, b) => far(a) - far(b));
    await on.withTool('j', () => on.pixel(first.at_mm), () => on.pixel(second.at_mm));
    await on.page.keyboard.press('Enter');
  },
  join: async (on: RandomEdits) => {
    // Two rods with a common end, where there are any.
    const { points, rods } = await on.plan();
    const ends = (rod: Rod) => (rod.closed ? [] : [rod.points[0], rod.points[rod.points.length - 1]]);
    const pairs = rods.flatMap((a, i) => rods.slice(i + 1).filter((b) => ends(b).some((end) => ends(a).includes(end))).map((b) => [a, b]));
    if (pairs.length === 0 || points.length === 0) return;
    const [a, b] = on.pick(pairs);
    await on.selectRod((rod) => rod.name === a.name);
    await on.page.keyboard.down('Shift');
    await on.selectRod((rod) => rod.name === b.name);
    await on.page.keyboard.up('Shift');
    await on.press(button(on, 'Join'));
  },
  'name of a point': async (on: RandomEdits) => {
    await on.selectPoints(1);
    await on.type(on.page.getByRole('textbox', { name: 'Name', exact: true }), on.freshName());
  },
  'name of a rod': async (on: RandomEdits) => {
    await on.selectRod();
    await on.type(on.page.getByRole('textbox', { name: 'Name', exact: true }), on.freshName());
  },
  title: async (on: RandomEdits) => on.type(on.page.getByRole('textbox', { name: 'Title' }), `Walk ${on.freshName()}`),
  stretch: async (on: RandomEdits) => on.type(spin(on, /^(Pre-stretch|Stretch along warp)$/), on.between(1.2, 1.6)),
  'stretch along weft': async (on: RandomEdits) => {
    const apart = on.page.getByRole('checkbox', { name: 'Different along warp and weft' });
    if (!(await apart.isChecked())) await apart.click();
    await on.type(spin(on, 'Stretch along weft'), on.between(1.2, 1.6));
  },
  'warp direction': async (on: RandomEdits) => on.type(spin(on, 'Warp direction, °'), on.between(-60, 60, 0)),
  fabric: async (on: RandomEdits) => on.choose(on.section('Fabric').getByRole('combobox', { name: 'Material' })),
  'bending of the fabric': async (on: RandomEdits) => on.type(spin(on, 'Bending stiffness, %'), on.between(40, 200, 0)),
  'mesh of the fabric': async (on: RandomEdits) => on.type(on.section('Fabric').getByRole('spinbutton', { name: 'Edge length, mm' }), on.between(6, 9)),
  'material of the rods': async (on: RandomEdits) => on.choose(on.section('All rods').getByRole('combobox', { name: 'Material' })),
  'mesh of the rods': async (on: RandomEdits) => on.type(on.section('All rods').getByRole('spinbutton', { name: 'Edge length, mm' }), on.between(3.5, 6)),
  hole: async (on: RandomEdits) => {
    await on.page.getByRole('button', { name: /^Hole in the fabric/ }).click();
    const { fabric } = await on.plan();
    await on.click(fabric.holes_mm.length > 1 ? await on.pixel(fabric.holes_mm[0]) : await on.somewhere());
  },
  pin: async (on: RandomEdits) => on.withTool('Shift+I', () => on.point()),
  attach: async (on: RandomEdits) => {
    await on.selectPoints(2);
    await on.press(button(on, 'Attach'));
  },
  'keep in a plane': async (on: RandomEdits) => {
    await on.selectPoints(4);
    await on.press(button(on, 'Keep in a plane'));
  },
  symmetry: async (on: RandomEdits) => on.choose(constraints(on).getByRole('combobox', { name: 'Mirror symmetry' })),
};

export const editKinds = Object.keys(kinds) as EditKind[];
