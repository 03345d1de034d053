// The bar of the plan: where it stands, and the first line that a newcomer reads.

import { effect } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { dragging, lookOnly, plan, planDock, toolHint, type PlanDock } from '../../core/store';
import { beganBefore } from '../layout_state';
import { Button, CommandButton } from '../parts/button';
import type { IconName } from '../parts/icon';
import { SnappingPopover } from './snapping_popover';

const docks: ReadonlyArray<{ dock: PlanDock; icon: IconName; label: string }> = [
  { dock: 'below', icon: 'panel-bottom', label: 'Plan below the shape' },
  { dock: 'beside', icon: 'side-by-side', label: 'Plan beside the shape' },
  { dock: 'full', icon: 'plan', label: 'Plan alone' },
];

export function PlanBar() {
  useEffect(
    () =>
      effect(() => {
        if (dragging.value !== 0) beganBefore.value = true;
      }),
    [],
  );
  return (
    <div class="view-bar">
      <h2>Plan</h2>
      <p class="hint soft">{isNew() && toolHint.value === '' && 'Drag a point of the plan.'}</p>
      {isNew() && <CommandButton id="help.guide" text="Show me around" />}
      <SnappingPopover />
      <div class="row" role="group" aria-label="Place of the plan">
        {docks.map(({ dock, icon, label }) => (
          <Button key={dock} icon={icon} label={label} pressed={planDock.value === dock} onClick={() => (planDock.value = dock)} />
        ))}
        <Button icon="close" label="Hide the plan" onClick={() => (planDock.value = 'hidden')} />
      </div>
    </div>
  );
}

/** Nobody has dragged anything in this browser yet. */
function isNew(): boolean {
  return !beganBefore.value && !lookOnly.value && plan.value !== null;
}
