// How the parts of the page lie, where the store does not say it.

import { effect, signal } from '@preact/signals';
import { inspectorOpen, treeOpen, uiScale } from '../core/store';

/** Share of the middle that the plan takes where it is not alone. */
export const planShare = signal(0.36);

/** Somebody has dragged a point in this browser before: the first line of help can go. */
export const beganBefore = signal(false);

/** The page is too narrow for three columns: one side column at a time lies over the middle, on demand. */
export const narrow = signal(false);
export type Side = 'tree' | 'inspector';
const drawer = signal<Side | ''>('');

export function sideShown(side: Side): boolean {
  if (narrow.value) return drawer.value === side;
  return side === 'tree' ? treeOpen.value : inspectorOpen.value;
}

export function toggleSide(side: Side): void {
  if (narrow.peek()) {
    drawer.value = drawer.peek() === side ? '' : side;
    return;
  }
  const open = side === 'tree' ? treeOpen : inspectorOpen;
  open.value = !open.peek();
}

const kNarrowest = 56;

/** Keeps `narrow` in step with the width of the page in rem. */
export function watchWidth(element: HTMLElement): () => void {
  const measure = () => {
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    narrow.value = element.clientWidth < kNarrowest * rem;
  };
  const observer = new ResizeObserver(measure);
  observer.observe(element);
  const end = effect(() => {
    void uiScale.value;
    requestAnimationFrame(measure);
  });
  return () => {
    observer.disconnect();
    end();
  };
}
