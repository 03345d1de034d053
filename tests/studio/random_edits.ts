// Edits of all kinds that the page offers, each made at a random place as a person makes it: by pointer in the plan, by keys,
// by fields, buttons and lists of the inspector.

import type { Page } from 'playwright-core';
import { RandomHands, stepOf, type Point, type Rod } from './random_hands';
import type { Place } from './studio_browser';

const spin = (on: RandomHands, name: string | RegExp) => on.page.getByRole('spinbutton', { name });
const button = (on: RandomHands, name: string | RegExp) => on.page.getByRole('button', { name, exact: true });
const constraints = (on: RandomHands) => on.section('Constraints');

async function dragged(on: RandomHands, from: Place): Promise<void> {
  const { mouse } = on.page;
  const to = [from[0] + on.below(31) - 15, from[1] + on.below(31) - 15] as Place;
  await mouse.move(...from);
  await mouse.down();
  await mouse.move(...to, { steps: 4 });
  await mouse.up();
}

async function drawn(on: RandomHands, key: string, places: (() => Promise<Place>)[]): Promise<void> {
  await on.withTool(key, ...places);
  await on.page.keyboard.press('Enter');
}

const kinds = {
  move: async (on: RandomHands) => dragged(on, await on.point()),
  'move a rod': async (on: RandomHands) => dragged(on, await on.onRod()),
  nudge: async (on: RandomHands) => {
    await on.selectPoints(1 + on.below(3));
    await on.page.keyboard.press(on.pick(['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown']));
  },
  place: async (on: RandomHands) => {
    await on.selectPoints(1);
    const field = on.page.getByRole('spinbutton', { name: on.pick(['x, mm', 'y, mm']), exact: true });
    if ((await field.count()) > 0) await on.type(field, String(Number(await field.first().inputValue()) + Number(on.between(-3, 3))));
  },
  'radius in plane': async (on: RandomHands) => {
    await on.selectPoints(1 + on.below(2));
    await on.type(spin(on, 'Radius in plane, mm'), on.between(0.6, 1.2));
  },
  'radius out of plane': async (on: RandomHands) => {
    await on.selectRod();
    await on.type(spin(on, 'Radius out of plane, mm'), on.between(0.3, 0.8));
  },
  'radius by slider': async (on: RandomHands) => {
    await on.selectPoints(1);
    const slider = on.page.getByRole('slider', { name: /^Radius in plane/ });
    if ((await slider.count()) === 0) return;
    for (let i = 0; i < 2; ++i) await slider.press('ArrowRight');
  },
  'scale radii': async (on: RandomHands) => {
    await on.selectRod();
    await on.type(spin(on, 'Scale radii to, %'), on.between(90, 112, 0));
  },
  'thicken or thin': async (on: RandomHands) => {
    await on.selectPoints(2);
    await on.page.keyboard.press(on.pick([']', '[']));
  },
  kink: async (on: RandomHands) => on.withTool('k', () => on.point()),
  'kink by switch': async (on: RandomHands) => {
    await on.selectPoints(1);
    await on.press(on.page.getByRole('checkbox', { name: 'Kink' }));
  },
  insert: async (on: RandomHands) => on.withTool('i', () => on.onRod()),
  cut: async (on: RandomHands) => on.withTool('c', () => on.onRod()),
  'cut at a point': async (on: RandomHands) => on.withTool('c', () => on.point()),
  rod: async (on: RandomHands) => drawn(on, 'p', [() => on.point(), () => on.point()]),
  'rod from rod to rod': async (on: RandomHands) => drawn(on, 'p', [() => on.onRod(), () => on.onRod()]),
  'ghost rod': async (on: RandomHands) => drawn(on, 'Shift+P', [() => on.point(), () => on.point()]),
  ring: async (on: RandomHands) => {
    await on.page.keyboard.press('o');
    const { mouse } = on.page;
    const middle = await on.free();
    await mouse.move(...middle);
    await mouse.down();
    await mouse.move(middle[0] + 10 + on.below(8), middle[1], { steps: 3 });
    await mouse.up();
  },
  ghost: async (on: RandomHands) => on.withTool('Shift+G', () => on.onRod()),
  'ghost by switch': async (on: RandomHands) => {
    await on.selectRod();
    await on.press(on.page.getByRole('checkbox', { name: 'Ghost' }));
  },
  closed: async (on: RandomHands) => {
    await on.selectRod((rod) => rod.points.length > 2);
    await on.press(on.page.getByRole('checkbox', { name: 'Closed' }));
  },
  curve: async (on: RandomHands) => {
    await on.selectRod((rod) => rod.points.length > 2);
    await on.choose(on.page.getByRole('combobox', { name: 'Curve' }));
  },
  erase: async (on: RandomHands) => on.withTool('e', () => on.onRod()),
  'delete a point': async (on: RandomHands) => {
    await on.selectPoints(1);
    await on.page.keyboard.press('Delete');
  },
  mirror: async (on: RandomHands) => {
    await on.selectRod();
    await on.press(button(on, on.pick(['Mirror x', 'Mirror y'])));
  },
  merge: async (on: RandomHands) => {
    const { points } = await on.plan();
    const first = on.pick(points);
    const far = (p: Point) => Math.hypot(p.at_mm[0] - first.at_mm[0], p.at_mm[1] - first.at_mm[1]);
    const [second] = points.filter((p) => p !== first).sort((a, b) => far(a) - far(b));
    await on.withTool('j', () => on.pixel(first.at_mm), () => on.pixel(second.at_mm));
    await on.page.keyboard.press('Enter');
  },
  join: async (on: RandomHands) => {
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
  'name of a point': async (on: RandomHands) => {
    await on.selectPoints(1);
    await on.type(on.page.getByRole('textbox', { name: 'Name', exact: true }), on.freshName());
  },
  'name of a rod': async (on: RandomHands) => {
    await on.selectRod();
    await on.type(on.page.getByRole('textbox', { name: 'Name', exact: true }), on.freshName());
  },
  title: async (on: RandomHands) => on.type(on.page.getByRole('textbox', { name: 'Title' }), `Walk ${on.freshName()}`),
  stretch: async (on: RandomHands) => on.type(spin(on, /^(Pre-stretch|Stretch along warp)$/), on.between(1.2, 1.6)),
  'stretch along weft': async (on: RandomHands) => {
    const apart = on.page.getByRole('checkbox', { name: 'Different along warp and weft' });
    if (!(await apart.isChecked())) await apart.click();
    await on.type(spin(on, 'Stretch along weft'), on.between(1.2, 1.6));
  },
  'warp direction': async (on: RandomHands) => on.type(spin(on, 'Warp direction, °'), on.between(-60, 60, 0)),
  fabric: async (on: RandomHands) => on.choose(on.section('Fabric').getByRole('combobox', { name: 'Material' })),
  'bending of the fabric': async (on: RandomHands) => on.type(spin(on, 'Bending stiffness, %'), on.between(40, 200, 0)),
  'mesh of the fabric': async (on: RandomHands) => on.type(on.section('Fabric').getByRole('spinbutton', { name: 'Edge length, mm' }), on.between(6, 9)),
  'material of the rods': async (on: RandomHands) => on.choose(on.section('All rods').getByRole('combobox', { name: 'Material' })),
  'mesh of the rods': async (on: RandomHands) => on.type(on.section('All rods').getByRole('spinbutton', { name: 'Edge length, mm' }), on.between(3.5, 6)),
  hole: async (on: RandomHands) => {
    await on.page.getByRole('button', { name: /^Hole in the fabric/ }).click();
    const { fabric } = await on.plan();
    await on.click(fabric.holes_mm.length > 1 ? await on.pixel(fabric.holes_mm[0]) : await on.somewhere());
  },
  pin: async (on: RandomHands) => on.withTool('Shift+I', () => on.point()),
  attach: async (on: RandomHands) => {
    await on.selectPoints(2);
    await on.press(button(on, 'Attach'));
  },
  'keep in a plane': async (on: RandomHands) => {
    await on.selectPoints(4);
    await on.press(button(on, 'Keep in a plane'));
  },
  symmetry: async (on: RandomHands) => on.choose(constraints(on).getByRole('combobox', { name: 'Mirror symmetry' })),
};

export type EditKind = keyof typeof kinds;
export const editKinds = Object.keys(kinds) as EditKind[];

export class RandomEdits {
  private readonly hands: RandomHands;
  private deck: EditKind[] = [];

  constructor(
    private readonly page: Page,
    seed: number,
  ) {
    this.hands = new RandomHands(page, seed);
  }

  /** Tries one edit; says which, and whether it became a step. Every kind has its turn before one comes again. */
  async next(): Promise<{ kind: EditKind; taken: boolean }> {
    if (this.deck.length === 0) this.deck = this.hands.shuffled(editKinds);
    const kind = this.deck.pop() ?? 'move';
    return { kind, taken: await this.make(kind) };
  }

  private async make(kind: EditKind): Promise<boolean> {
    const { page } = this;
    const at = await stepOf(page);
    await kinds[kind](this.hands);
    const taken = await this.outcome(at, kind);
    // What was refused says so until it is put away; a tool gives way to selecting, then nothing is selected.
    const dismiss = page.getByRole('button', { name: 'Dismiss' });
    if (await dismiss.isVisible()) await dismiss.click();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('Escape');
    await this.leaveField();
    return taken;
  }

  /** Waits until there is another step, or a word why not; an edit that changes nothing says neither. */
  private async outcome(at: number, kind: EditKind): Promise<boolean> {
    const { page } = this;
    const answered = (before: number) => {
      const hook = window.lissomTest;
      const refused = hook.fault() !== null || document.querySelector('.field-problem') !== null;
      return hook.busy() === '' && (hook.counts().at !== before || refused);
    };
    await page.waitForFunction(answered, at, { timeout: 1000, polling: 20 }).catch(() => undefined);
    // A busy machine may need longer, but never for ever.
    const idle = page.waitForFunction(() => window.lissomTest.busy() === '', undefined, { timeout: 60_000, polling: 20 });
    await idle.catch(async (e) => {
      const [busy, plan] = await page.evaluate(() => [window.lissomTest.busy(), JSON.stringify(window.lissomTest.plan())]);
      throw new Error(`after "${kind}": still busy with ${busy}, of the plan ${plan}`, { cause: e });
    });
    return (await stepOf(page)) !== at;
  }

  /** Keys mean the design again, not a field. */
  private leaveField(): Promise<void> {
    return this.page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  }
}
