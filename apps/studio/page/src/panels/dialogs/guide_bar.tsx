// The way round, for those who ask for it: six sentences, one for each thing to try.

import { signal } from '@preact/signals';
import { run } from '../../core/commands';
import type { WorkMode } from '../../core/store';
import { Button } from '../parts/button';

const steps: ReadonlyArray<{ mode: WorkMode; text: string }> = [
  { mode: 'draw', text: 'Drag a point of the plan: the shape follows at once. Undo takes everything back, in order.' },
  { mode: 'draw', text: 'Press P and click from joint to joint to draw a rod; Enter ends it, and the fabric forms anew.' },
  { mode: 'draw', text: 'With nothing selected, move the pre-stretch at the right: more stretch lifts the shape.' },
  { mode: 'explore', text: 'Find modes: what the shape would do most easily. Choose one, set its amplitude, adopt it.' },
  { mode: 'shape', text: 'Click the shape and pull the handle. Bars say what would change; Enter makes it real.' },
  { mode: 'make', text: 'The list turns green by itself. Each button says what it writes and where.' },
];

/** Which sentence is shown; -1: none. */
const step = signal(-1);

export function beginGuide(): void {
  go(0);
}

function go(to: number): void {
  step.value = to < steps.length ? to : -1;
  const now = steps[step.peek()];
  if (now) run(`mode.${now.mode}`);
}

export function GuideBar() {
  const at = step.value;
  const now = steps[at];
  if (!now) return null;
  return (
    <section class="notice" aria-label="The way round">
      <p role="status">
        <span class="soft">
          {at + 1} of {steps.length}
        </span>{' '}
        {now.text}
      </p>
      <Button disabled={at === 0} onClick={() => go(at - 1)}>
        Back
      </Button>
      <Button class="primary" onClick={() => go(at + 1)}>
        {at === steps.length - 1 ? 'Done' : 'Next'}
      </Button>
      <Button icon="close" label="End the way round" onClick={() => go(steps.length)} />
    </section>
  );
}
