// The flat plan as a component. Panels place it once; it fills its container and follows its size.

import type { ComponentChildren } from 'preact';

export function PlanView({ children }: { children?: ComponentChildren }) {
  return <div class="plan-view">{children}</div>;
}
