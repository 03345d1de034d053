// Bars of what will change: from, to, and what is at its limit.

import type { PreviewPack } from '../../core/protocol';
import { changeBars } from '../logic/changes';

const kHalf = 50;

export function Changes({ of }: { of: PreviewPack['changes'] }) {
  if (of.length === 0) return null;
  return (
    <ul class="changes" aria-label="What will change most">
      {changeBars(of).map((bar) => (
        <li key={bar.parameter} class="change" data-bound={bar.atBound}>
          <span class="change-name">{bar.parameter}</span>
          <span class="number">{bar.text}</span>
          <svg class="change-bar" viewBox={`0 0 ${2 * kHalf} 6`} preserveAspectRatio="none" aria-hidden="true">
            <rect class="change-track" width={2 * kHalf} height="6" />
            <rect
              class="change-fill"
              x={bar.length < 0 ? kHalf * (1 + bar.length) : kHalf}
              width={Math.max(0.6, kHalf * Math.abs(bar.length))}
              height="6"
            />
          </svg>
          {bar.atBound && <span class="small change-bound">at its limit</span>}
        </li>
      ))}
    </ul>
  );
}
