// The view that is on the page, for commands that need more than the store (pictures).

import type { View } from './view';

let view: View | null = null;

export function currentView(): View | null {
  return view;
}

export function setCurrentView(now: View | null): void {
  view = now;
}
