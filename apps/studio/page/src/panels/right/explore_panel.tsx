// What the shape would do most easily: a list of modes, one shown as a breathing ghost, adopted with an amplitude.

import { useComputed } from '@preact/signals';
import { announce } from '../../core/commands';
import { send } from '../../core/connection';
import type { ModesEvent } from '../../core/protocol';
import { jobs, lookOnly, measures, modeAmplitude, modeBreathes, modes, reducedMotion, shownMode } from '../../core/store';
import { fixed } from '../logic/number_text';
import { sentence } from '../logic/words';
import { Button } from '../parts/button';
import { Switch } from '../parts/choice';
import { Field } from '../parts/field';
import { Section } from '../parts/section';
import { BranchesFinder } from './branches_finder';

const kModes = 6;

const groups: Readonly<Record<ModesEvent['modes'][number]['group'], string>> = {
  points: 'moves points',
  radii: 'changes radii',
  stretch: 'changes the stretch',
};

export function ExplorePanel() {
  const found = modes.value;
  const busy = jobs.value.modes?.state === 'running';
  const list = found?.modes ?? [];
  return (
    <>
      <Section title="Modes" aside={busy ? 'looking' : list.length > 0 ? `${list.length} found` : ''}>
        <p class="soft small">Changes of the design that move the shape most for the least, largest first.</p>
        {found?.stale && list.length > 0 && <Stale busy={busy} />}
        {list.length === 0 ? (
          <Button icon="modes" class="primary" disabled={busy || lookOnly.value} onClick={find}>
            Find {kModes} modes
          </Button>
        ) : (
          <ModeList of={list} />
        )}
        {list.length > 0 && <Shown of={list} />}
      </Section>
      <BranchesFinder />
    </>
  );
}

function find(): void {
  void send({ do: 'modes', count: kModes });
}

function Stale({ busy }: { busy: boolean }) {
  return (
    <div class="note warn row between">
      <p>These modes belong to an earlier state of the design.</p>
      <Button icon="modes" disabled={busy} onClick={find}>
        Find anew
      </Button>
    </div>
  );
}

function ModeList({ of }: { of: ModesEvent['modes'] }) {
  const strongest = Math.max(...of.map((mode) => mode.value), Number.MIN_VALUE);
  return (
    <ol class="mode-list" aria-label="Modes">
      {of.map((mode, k) => (
        <li key={k}>
          <button
            type="button"
            class="mode"
            aria-pressed={shownMode.value === k}
            onClick={() => (shownMode.value = shownMode.value === k ? -1 : k)}
          >
            <span class="row between">
              <strong>Mode {k + 1}</strong>
              <span class="small soft">strength {fixed(100 * (mode.value / strongest), 0)} %</span>
            </span>
            <span>{sentence(mode.sentence || groups[mode.group])}</span>
          </button>
        </li>
      ))}
    </ol>
  );
}

function Shown({ of }: { of: ModesEvent['modes'] }) {
  const largest = useComputed(() => {
    const size = Math.max(...(measures.value?.box_mm ?? [100]));
    return Math.max(5, Math.ceil(0.15 * size));
  });
  const k = shownMode.value;
  if (k < 0 || k >= of.length) return <p class="soft">Choose a mode to see what it does.</p>;
  const adopt = async () => {
    const answer = await send({ do: 'mode_adopt', mode: k, amplitude_mm: modeAmplitude.peek() });
    if (!answer.ok) return;
    announce(`Mode ${k + 1} adopted with ${fixed(modeAmplitude.peek(), 1)} mm.`);
    shownMode.value = -1;
  };
  return (
    <>
      <Field
        label="Amplitude"
        unit="mm"
        digits={1}
        step={0.5}
        range={[-largest.value, largest.value]}
        initial={10}
        value={modeAmplitude.value}
        onPreview={(value) => (modeAmplitude.value = value)}
        onCommit={(value) => {
          modeAmplitude.value = value;
          return null;
        }}
      />
      <Switch
        label="Animate"
        help={reducedMotion.value ? 'Your system asks for less motion' : 'The ghost goes from minus to plus the amplitude'}
        checked={modeBreathes.value}
        onSwitch={(on) => (modeBreathes.value = on)}
      />
      <div class="row">
        <Button icon="check" class="primary" disabled={lookOnly.value} onClick={() => void adopt()}>
          Adopt mode {k + 1}
        </Button>
        <Button onClick={() => (shownMode.value = -1)}>Hide it</Button>
      </div>
    </>
  );
}
