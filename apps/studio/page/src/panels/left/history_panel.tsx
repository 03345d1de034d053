// Every step by its name: a click goes there and back.

import { send } from '../../core/connection';
import { history } from '../../core/store';
import { whenText } from '../logic/number_text';
import { useEffect, useRef } from 'preact/hooks';

export function HistoryPanel() {
  const list = useRef<HTMLOListElement>(null);
  const now = history.value;
  const at = now?.at ?? 0;
  useEffect(() => list.current?.querySelector('[aria-current]')?.scrollIntoView({ block: 'nearest' }), [at]);
  if (!now) return <p class="side-empty soft">Nothing done yet.</p>;
  const steps = [{ title: 'As opened', seconds: Number.NaN }, ...now.steps];
  return (
    <ol ref={list} class="history">
      {steps.map((step, k) => (
        <li key={k}>
          <button
            type="button"
            class="history-step"
            data-undone={k > at}
            aria-current={k === at ? 'step' : undefined}
            onClick={() => void send({ do: 'go_to', step: k })}
          >
            <span class="tree-title">{step.title}</span>
            <span class="small soft">
              {k === now.saved_at ? 'saved' : Number.isFinite(step.seconds) ? whenText(step.seconds, Date.now() / 1000) : ''}
            </span>
          </button>
        </li>
      ))}
    </ol>
  );
}
