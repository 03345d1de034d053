// The reason behind the verdict: figures, the worst places, the remedy, the warnings.

import { effect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { edit, send } from '../../core/connection';
import type { VerdictEvent } from '../../core/protocol';
import { connection, dialog, log, verdict, warnings } from '../../core/store';
import { durationText, short, withUnit } from '../logic/number_text';
import { sentence, sentenceCase } from '../logic/words';
import { Button } from '../parts/button';
import { Facts } from '../parts/facts';
import { place } from '../parts/popover';
import { isPlace, selectPlace } from '../select_place';
import { presentLine } from './present_line';
import { WarningList } from './warning_list';

const kLines = 20;

export function VerdictPanel() {
  const panel = useRef<HTMLDivElement>(null);
  useEffect(
    () =>
      effect(() => {
        const element = panel.current;
        const button = document.getElementById('verdict-button');
        const wanted = dialog.value === 'verdict';
        if (!element || wanted === element.matches(':popover-open')) return;
        element.togglePopover(wanted);
        if (wanted && button) place(element, button);
      }),
    [],
  );
  return (
    <div
      ref={panel}
      id="verdict-panel"
      class="popover verdict-panel"
      popover="auto"
      role="dialog"
      aria-label="Verdict"
      onToggle={(event) => {
        if (event.newState === 'closed' && dialog.peek() === 'verdict') dialog.value = '';
      }}
    >
      {dialog.value === 'verdict' && <Reason />}
    </div>
  );
}

function Reason() {
  const now = verdict.value;
  const line = presentLine.value;
  return (
    <div class="stack">
      <div class="row between">
        <h2>{line.text}</h2>
        <Button icon="close" label="Close" onClick={() => (dialog.value = '')} />
      </div>
      {now && line.tone === 'calm' && <p>{sentence(now.sentence)}</p>}
      {connection.value === 'lost' && (
        <p>If the studio was ended, start it again and open the address that it prints: what was not saved is offered there.</p>
      )}
      {now && <Remedy of={now} />}
      {now && <Worst of={now} />}
      {now && <Figures of={now} />}
      <h3>Warnings</h3>
      {warnings.value.length === 0 ? <p class="soft">None: nothing speaks against making it.</p> : <WarningList of={warnings.value} />}
      <div class="row">
        <Button icon="play" onClick={() => void send({ do: 'settle' })}>
          Settle again
        </Button>
        <Button icon="reset" onClick={() => void send({ do: 'settle', from: 'flat' })}>
          Release from flat
        </Button>
      </div>
      <Said />
    </div>
  );
}

/** The newest lines of the engine's log. */
function Said() {
  const lines = log.value.slice(-kLines);
  if (lines.length === 0) return null;
  return (
    <details>
      <summary>What the engine said</summary>
      <ol class="small soft">
        {lines.map((line, k) => (
          <li key={k}>{line}</li>
        ))}
      </ol>
    </details>
  );
}

function Remedy({ of }: { of: VerdictEvent }) {
  const remedy = of.remedy;
  if (!remedy) return null;
  return (
    <div class="note warn row between">
      <p>{sentence(remedy.text)}</p>
      <Button icon="wrench" class="primary" onClick={() => void edit(remedy.edit)}>
        Do it
      </Button>
    </div>
  );
}

function Worst({ of }: { of: VerdictEvent }) {
  if (of.worst.length === 0) return null;
  return (
    <>
      <h3>Where it is largest</h3>
      <ul>
        {of.worst.map((worst) => (
          <li key={`${worst.what} ${worst.where}`}>
            <button type="button" class="place-row" disabled={!isPlace(worst)} title="Select it" onClick={() => selectPlace(worst)}>
              <span>
                {sentenceCase(worst.what)} <span class="soft">{worst.where}</span>
              </span>
              <span class="number">{withUnit(worst.value, worst.unit)}</span>
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}

function Figures({ of }: { of: VerdictEvent }) {
  return (
    <Facts
      of={[
        ['Largest force left', `${short(of.residual_n, 2)} N`],
        ['Iterations', `${of.iterations} (${of.factorizations} factorizations)`],
        ['Time', durationText(of.milliseconds)],
        ['Softest mode', of.lowest_mode_n_per_m === null ? 'not looked at' : `${short(of.lowest_mode_n_per_m)} N/m`],
        ['Modes that release energy', String(of.negative_modes)],
        ['Energy', `${short(of.energy_mj)} mJ`],
      ]}
    />
  );
}
