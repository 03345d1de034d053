// In Shape what is selected is held: the handle is taken when the selection changes there, taken again when the design has
// become another one (accepted, undone), and let go when the mode ends.

import { computed, effect } from '@preact/signals-core';
import { beginHandle, cancelHandle } from './handles';
import { emptySelection } from './selection';
import * as store from './store';

/** Selecting by box or Shift makes many changes at once: the last one counts. */
const kRestMs = 60;

export function holdInShape(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const revision = computed(() => store.settledShape.value?.plan_revision ?? -1);
  const fitting = computed(() => store.jobs.value.fit?.state === 'running');
  const ends = [
    effect(() => {
      const { points, nodes } = store.selection.value;
      void revision.value;
      void store.still.value;
      const ready = store.workMode.value === 'shape' && !store.lookOnly.value && !fitting.value;
      clearTimeout(timer);
      if (ready) timer = setTimeout(() => void beginHandle(), points.size + nodes.size > 0 ? kRestMs : 0);
      else if (store.handleCenter.peek() && !fitting.peek()) cancelHandle();
    }),
    // Names and numbers mean something else in another design.
    effect(() => {
      void store.design.value;
      store.still.value = emptySelection;
    }),
    // The engine has let go (accepted, or the design has changed): so does the page.
    effect(() => {
      if (store.handle.value?.active === false || store.connection.value !== 'open') store.handleCenter.value = null;
    }),
  ];
  return () => {
    clearTimeout(timer);
    ends.forEach((end) => end());
  };
}
