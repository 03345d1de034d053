// What has to be there before the page is drawn.

import { effect, type Signal } from '@preact/signals';
import { dialog, project, reducedMotion, systemDark } from '../core/store';
import { registerPanelCommands } from './commands';
import { dirty } from './files';
import { keepSettings } from './settings';
import { watchJobs } from './verdict/job_ends';

export function startPanels(storage: Storage): void {
  registerPanelCommands();
  follow('(prefers-color-scheme: dark)', systemDark);
  follow('(prefers-reduced-motion: reduce)', reducedMotion);
  keepSettings(storage);
  watchJobs();
  effect(() => {
    const name = project.value?.file || project.value?.title || '';
    document.title = name === '' ? 'lissom studio' : `${dirty.value ? '• ' : ''}${name} – lissom`;
  });
  // Where nothing is open, work begins at the start page.
  effect(() => {
    if (project.value?.kind === 'none') dialog.value = 'start';
  });
}

/** Keeps a signal in step with what the operating system asks for. */
function follow(query: string, asked: Signal<boolean>): void {
  const media = matchMedia(query);
  asked.value = media.matches;
  media.addEventListener('change', () => (asked.value = media.matches));
}
