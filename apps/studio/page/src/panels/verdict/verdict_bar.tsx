// The foot of the page: the verdict, jobs under way, warnings; what was refused stands above it.

import { dialog, jobs, warnings } from '../../core/store';
import { counted } from '../logic/number_text';
import { Icon } from '../parts/icon';
import { FaultBar } from './fault_bar';
import { JobChip } from './job_chip';
import { LiveRegion } from './live_region';
import { presentLine } from './present_line';
import { VerdictPanel } from './verdict_panel';

export function VerdictBar() {
  const line = presentLine.value;
  const open = dialog.value === 'verdict';
  const under = Object.values(jobs.value).filter((job) => job?.state === 'running');
  const count = warnings.value.length;
  return (
    <footer class="foot">
      <FaultBar />
      <VerdictPanel />
      <div class="verdict" data-tone={line.tone}>
        <button
          type="button"
          id="verdict-button"
          class="verdict-line"
          aria-expanded={open}
          aria-controls="verdict-panel"
          title="Say why, and what to do"
          onClick={() => (dialog.value = open ? '' : 'verdict')}
        >
          {(line.tone === 'bad' || line.tone === 'warn') && <Icon name={line.tone === 'bad' ? 'trouble' : 'warning'} />}
          <span class="verdict-text">{line.text}</span>
          {line.details.map((detail) => (
            <span key={detail} class="verdict-detail">
              {detail}
            </span>
          ))}
        </button>
        {under.map((job) => job && <JobChip key={job.job} job={job} />)}
        {count > 0 && (
          <button type="button" class="verdict-warnings" aria-controls="verdict-panel" onClick={() => (dialog.value = open ? '' : 'verdict')}>
            <Icon name="warning" />
            {counted(count, 'warning')}
          </button>
        )}
      </div>
      <LiveRegion />
    </footer>
  );
}
