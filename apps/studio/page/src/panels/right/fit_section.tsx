// The design is being fitted to the target, or was: how it fell, what is at its limit, compare and revert.

import { run } from '../../core/commands';
import { send } from '../../core/connection';
import { fit, jobs, show } from '../../core/store';
import { fixed, short } from '../logic/number_text';
import { parameterText } from '../logic/changes';
import { listText, sentence } from '../logic/words';
import { Button } from '../parts/button';
import { Switch } from '../parts/choice';
import { Facts } from '../parts/facts';
import { Section } from '../parts/section';
import { FitPlot } from './fit_plot';

export function FitSection({ fitting }: { fitting: boolean }) {
  const now = fit.value;
  const job = jobs.value.fit;
  return (
    <Section title={fitting ? 'Fitting' : 'Last fit'}>
      {fitting && (
        <div class="row between">
          <span>
            Step {job?.iteration ?? 0}, {short(job?.value ?? Number.NaN)} mm from the target
          </span>
          <Button icon="stop" label="Stop and keep the best so far" onClick={() => void send({ do: 'cancel', job: 'fit' })}>
            Stop
          </Button>
        </div>
      )}
      {now && now.records.length > 0 && <FitPlot records={now.records} />}
      {now && !fitting && (
        <>
          {now.sentence && <p>{sentence(now.sentence)}</p>}
          <Facts
            of={[
              ['Distance before', `${short(now.before_mm)} mm`],
              ['Distance after', `${short(now.after_mm)} mm (${fixed(fallen(now.before_mm, now.after_mm), 0)} % less)`],
              ['Constraints off by', `${short(now.constraint_mm, 2)} mm`],
            ]}
          />
          {now.at_bounds.length > 0 && <p class="note">At their limits: {listText(now.at_bounds.map(parameterText), 6)}.</p>}
          <div class="row">
            <Switch label="Compare with before" checked={show.previous.value} onSwitch={(on) => (show.previous.value = on)} />
            <Button icon="undo" onClick={() => run('edit.undo')}>
              Revert
            </Button>
          </div>
        </>
      )}
    </Section>
  );
}

/** Percent. */
function fallen(before: number, after: number): number {
  return before > 0 ? 100 * (1 - after / before) : 0;
}
