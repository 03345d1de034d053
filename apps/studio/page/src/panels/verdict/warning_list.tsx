// Warnings, each with its place and its remedy: one click, one step of history.

import { send } from '../../core/connection';
import type { Warning } from '../../core/protocol';
import { jobs, lookOnly } from '../../core/store';
import { withUnit } from '../logic/number_text';
import { sentence, sentenceCase } from '../logic/words';
import { Button } from '../parts/button';
import { Icon } from '../parts/icon';
import { isPlace, selectPlace } from '../select_place';

export function WarningList({ of }: { of: readonly Warning[] }) {
  return (
    <ul class="warnings">
      {of.map((warning, k) => (
        <li key={`${warning.what} ${warning.where}`} class="note warn stack">
          <p class="row">
            <Icon name="warning" />
            <strong>
              {sentenceCase(warning.what)}: {withUnit(warning.value, warning.unit)}
            </strong>
          </p>
          <p>
            {warning.where && <span class="soft">{warning.where}: </span>}
            {sentence(warning.remedy)}
          </p>
          <WarningActions warning={warning} index={k} />
        </li>
      ))}
    </ul>
  );
}

/** The remedy of a warning, and its place. */
export function WarningActions({ warning, index }: { warning: Warning | undefined; index: number }) {
  const busy = jobs.value.remedy?.state === 'running';
  if (!warning) return null;
  return (
    <div class="row">
      {warning.one_click && (
        <Button icon="wrench" disabled={busy || lookOnly.value} onClick={() => void send({ do: 'remedy', warning: index })}>
          Do it
        </Button>
      )}
      {isPlace(warning) && <Button onClick={() => selectPlace(warning)}>Show where</Button>}
    </div>
  );
}
