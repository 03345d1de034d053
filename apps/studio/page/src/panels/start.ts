// What has to be there before the page is drawn.

import type { Signal } from '@preact/signals';
import { reducedMotion, systemDark } from '../core/store';
import { registerPanelCommands } from './commands';
import { keepSettings } from './settings';
import { watchJobs } from './verdict/job_ends';

export function startPanels(storage: Storage): void {
  registerPanelCommands();
  follow('(prefers-color-scheme: dark)', systemDark);
  follow('(prefers-reduced-motion: reduce)', reducedMotion);
  keepSettings(storage);
  watchJobs();
}

/** Keeps a signal in step with what the operating system asks for. */
function follow(query: string, asked: Signal<boolean>): void {
  const media = matchMedia(query);
  asked.value = media.matches;
  media.addEventListener('change', () => (asked.value = media.matches));
}
