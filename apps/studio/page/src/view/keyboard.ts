// Keys of the whole page, in this order: the handle that is held, the active tool, the view that has the focus, commands.

import { acceptHandle, cancelHandle } from '../core/handles';
import { dispatch } from '../core/keys';
import * as store from '../core/store';
import { toolOf } from '../tools/index';
import { turnView } from './camera_motion';
import { typed } from './local';
import { endTyping, shapeKey } from './shape_keys';

/** Listens on the document; the function that it returns ends it. */
export function listenKeys(): () => void {
  const end = new AbortController();
  document.addEventListener('keydown', (event) => {
    if (!event.defaultPrevented && taken(event)) event.preventDefault();
  }, { signal: end.signal });
  return () => end.abort();
}

function taken(event: KeyboardEvent): boolean {
  const target = event.target instanceof Element ? event.target : null;
  // Escape closes what is open over the page first; the browser does it.
  if (event.key === 'Escape' && document.querySelector('dialog:modal, :popover-open')) return false;
  // Dialogs and menus have keys of their own; of the commands only those with Ctrl reach past them.
  if (target?.closest('dialog, [popover]') || document.querySelector('dialog:modal')) return event.ctrlKey && dispatch(event, target);
  const overView = target === null || target === document.body || target.closest('.view-surface') !== null;
  if (overView) {
    if (heldKey(event)) return true;
    // Arrows turn the shape when it has the focus, and move what is selected otherwise.
    if (target?.hasAttribute('data-turns') && turnKey(event)) return true;
    if (toolOf(store.activeTool.peek()).key?.(event)) return true;
  }
  return dispatch(event, target);
}

function heldKey(event: KeyboardEvent): boolean {
  if (store.workMode.peek() !== 'shape' || store.handleCenter.peek() === null) return false;
  if (event.key === 'Escape') {
    if (typed.peek() !== '') endTyping();
    else cancelHandle();
    return true;
  }
  if (event.key === 'Enter') {
    if (typed.peek() !== '') endTyping();
    else acceptHandle();
    return true;
  }
  return shapeKey(event);
}

const kStep = 24;
const kSteps: Record<string, [number, number]> = {
  ArrowLeft: [kStep, 0],
  ArrowRight: [-kStep, 0],
  ArrowUp: [0, kStep],
  ArrowDown: [0, -kStep],
};

function turnKey(event: KeyboardEvent): boolean {
  const step = kSteps[event.key];
  if (!step || event.ctrlKey || event.metaKey || event.altKey) return false;
  turnView(step[0], step[1], event.shiftKey);
  return true;
}
