// A job under way: what it does, how far it is, and a way to end it.

import { send } from '../../core/connection';
import type { JobEvent, JobName } from '../../core/protocol';
import { short } from '../logic/number_text';
import { Button } from '../parts/button';

const names: Readonly<Record<JobName, string>> = {
  modes: 'Looking for modes',
  fit: 'Fitting the design to the target',
  branches: 'Looking for other stable shapes',
  settle: 'Settling',
  remedy: 'Working out the remedy',
};

/** What a job does, for people. */
export function jobTitle(job: JobName): string {
  return names[job] ?? job;
}

export function JobChip({ job }: { job: JobEvent }) {
  const title = jobTitle(job.job);
  const known = job.fraction >= 0;
  return (
    <div class="job" role="group" aria-label={title}>
      <span>{title}</span>
      {known ? (
        <progress class="progress" value={job.fraction} max={1} aria-label={title} />
      ) : (
        <span class="soft">
          {job.iteration > 0 && `step ${job.iteration}, `}
          {job.unit === '' ? job.detail : `${short(job.value, 2)} ${job.unit}`}
        </span>
      )}
      <Button icon="stop" label={`Stop: ${title.toLowerCase()}`} onClick={() => void send({ do: 'cancel', job: job.job })} />
    </div>
  );
}
