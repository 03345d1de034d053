// The bar between two parts: dragged, or moved with the arrow keys.

import type { TargetedKeyboardEvent, TargetedPointerEvent } from 'preact';

interface SplitterProps {
  label: string;
  /** Share of the second part, 0 to 1. */
  share: number;
  /** How the parts lie: one above the other, or side by side. */
  across: 'rows' | 'columns';
  onShare: (share: number) => void;
}

const smallest = 0.15;
const largest = 0.85;

export function Splitter({ label, share, across, onShare }: SplitterProps) {
  const set = (wanted: number) => onShare(Math.max(smallest, Math.min(largest, wanted)));

  const moved = (event: TargetedPointerEvent<HTMLDivElement>) => {
    const bar = event.currentTarget;
    const parent = bar.parentElement;
    if (!bar.hasPointerCapture(event.pointerId) || !parent) return;
    const box = parent.getBoundingClientRect();
    set(across === 'rows' ? (box.bottom - event.clientY) / box.height : (box.right - event.clientX) / box.width);
  };

  const pressed = (event: TargetedKeyboardEvent<HTMLDivElement>) => {
    const grow = across === 'rows' ? 'ArrowUp' : 'ArrowLeft';
    const shrink = across === 'rows' ? 'ArrowDown' : 'ArrowRight';
    const wanted: Readonly<Record<string, number>> = {
      [grow]: share + 0.02,
      [shrink]: share - 0.02,
      PageUp: share + 0.1,
      PageDown: share - 0.1,
      Home: smallest,
      End: largest,
    };
    const to = wanted[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    set(to);
  };

  return (
    <div
      class="splitter"
      role="separator"
      tabIndex={0}
      aria-label={label}
      aria-orientation={across === 'rows' ? 'horizontal' : 'vertical'}
      aria-valuemin={Math.round(100 * smallest)}
      aria-valuemax={Math.round(100 * largest)}
      aria-valuenow={Math.round(100 * share)}
      aria-valuetext={`${Math.round(100 * share)} %`}
      onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
      onPointerMove={moved}
      onKeyDown={pressed}
      onDblClick={() => set(across === 'rows' ? 0.34 : 0.5)}
    />
  );
}
