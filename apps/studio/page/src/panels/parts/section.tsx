// A part of a side panel that folds.

import type { ComponentChildren } from 'preact';
import { Icon } from './icon';

interface SectionProps {
  title: string;
  /** What stands at the right of the title. */
  aside?: ComponentChildren;
  open?: boolean;
  children: ComponentChildren;
}

export function Section({ title, aside, open = true, children }: SectionProps) {
  return (
    <details class="section" open={open}>
      <summary>
        <Icon name="right" />
        <h2>{title}</h2>
        {aside !== undefined && <span class="section-aside small soft">{aside}</span>}
      </summary>
      <div class="section-body stack">{children}</div>
    </details>
  );
}
