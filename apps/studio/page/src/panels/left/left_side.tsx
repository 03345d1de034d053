// The left column: what there is, and what was done.

import { Section } from '../parts/section';
import { history } from '../../core/store';
import { sideShown } from '../layout_state';
import { HistoryPanel } from './history_panel';
import { Tree } from './tree';

export function LeftSide() {
  if (!sideShown('tree')) return null;
  const steps = history.value?.steps.length ?? 0;
  return (
    <nav class="side left" aria-label="Scene and history">
      <div class="side-body">
        <Tree />
      </div>
      <div class="side-foot">
        <Section title="History" aside={steps === 0 ? 'no steps yet' : `${history.value?.at} of ${steps}`}>
          <HistoryPanel />
        </Section>
      </div>
    </nav>
  );
}
