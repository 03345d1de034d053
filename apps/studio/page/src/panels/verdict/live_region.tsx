// Says verdicts and what was done to screen readers: not every iterate, but what became of the shape once it rests.

import { effect } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { announce } from '../../core/commands';
import { announcement, verdict } from '../../core/store';
import { presentLine } from './present_line';

const kQuiet = 700;

export function LiveRegion() {
  useEffect(() => {
    let said = '';
    let timer: ReturnType<typeof setTimeout> | undefined;
    const end = effect(() => {
      const now = verdict.value;
      const line = presentLine.value;
      clearTimeout(timer);
      if (line.tone === 'busy') return;
      const what = `${line.tone} ${now?.name} ${now?.note}`;
      if (what === said) return;
      timer = setTimeout(() => {
        said = what;
        announce(line.text);
      }, kQuiet);
    });
    return () => {
      end();
      clearTimeout(timer);
    };
  }, []);
  return (
    <div class="visually-hidden" role="status" aria-live="polite">
      {announcement.value}
    </div>
  );
}
