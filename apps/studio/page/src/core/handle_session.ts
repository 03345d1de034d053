// In Shape what is selected is held: the handle is taken when the selection changes there, and let go when the mode ends.

import { effect } from '@preact/signals-core';
import { beginHandle, cancelHandle } from './handles';
import * as store from './store';

/** Selecting by box or Shift makes many changes at once: the last one counts. */
const kRest = 60;

export function holdInShape(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const ends = [
    effect(() => {
      const { points, nodes } = store.selection.value;
      const ready = store.workMode.value === 'shape' && !store.lookOnly.value;
      clearTimeout(timer);
      if (ready) timer = setTimeout(() => void beginHandle(), points.size + nodes.size > 0 ? kRest : 0);
      else if (store.handleCenter.peek()) cancelHandle();
    }),
    // The engine has let go (accepted, or another page did): so does the page.
    effect(() => {
      if (store.handle.value?.active === false) store.handleCenter.value = null;
    }),
    // A new mesh has other nodes: hold again what is still selected by name.
    effect(() => {
      if (store.connection.value !== 'open') store.handleCenter.value = null;
    }),
  ];
  return () => {
    clearTimeout(timer);
    ends.forEach((end) => end());
  };
}
