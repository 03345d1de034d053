// What became of jobs: said to screen readers, and shown where one came to nothing.

import { effect } from '@preact/signals';
import { announce } from '../../core/commands';
import type { JobEvent } from '../../core/protocol';
import { fault, jobs } from '../../core/store';
import { sentence } from '../logic/words';
import { jobTitle } from './job_chip';

export function watchJobs(): () => void {
  const known = new Map<string, JobEvent['state']>();
  return effect(() => {
    for (const job of Object.values(jobs.value)) {
      const before = known.get(job.job);
      known.set(job.job, job.state);
      if (before !== 'running' || job.state === 'running') continue;
      const text = job.detail === '' ? '' : sentence(job.detail);
      if (job.state === 'failed') {
        const message = `${jobTitle(job.job)} came to nothing: ${job.detail || 'no reason was given'}`;
        fault.value = { code: 'job', where: '', message, hint: '' };
      } else {
        announce(job.state === 'done' ? text || `${jobTitle(job.job)}: done.` : `${jobTitle(job.job)}: stopped.`);
      }
    }
  });
}
