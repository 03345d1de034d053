// The middle: tools, the shape, other stable shapes, the plan.

import { planDock, project } from '../../core/store';
import { PlanView } from '../../view/plan_view';
import { Viewport } from '../../view/viewport';
import { planShare } from '../layout_state';
import { Splitter } from '../parts/splitter';
import { BranchStrip } from './branch_strip';
import { Legends } from './legends';
import { PlanBar } from './plan_bar';
import { ToolStrip } from './tool_strip';

export function Middle() {
  // What is only looked at has no plan.
  const dock = project.value?.kind === 'structure' ? 'hidden' : planDock.value;
  const both = dock === 'below' || dock === 'beside';
  return (
    <main class="middle">
      <ToolStrip />
      <div class="views" data-dock={dock} ref={(element) => element?.style.setProperty('--plan-share', `${100 * planShare.value}%`)}>
        <section class="view" aria-label="Shape" hidden={dock === 'full'}>
          <div class="canvas-place">
            <Viewport>
              <Legends />
            </Viewport>
          </div>
          <BranchStrip />
        </section>
        {both && (
          <Splitter
            label="Size of the plan"
            share={planShare.value}
            across={dock === 'below' ? 'rows' : 'columns'}
            onShare={(share) => (planShare.value = share)}
          />
        )}
        <section class="view" aria-label="Plan" hidden={dock === 'hidden'}>
          <PlanBar />
          <div class="canvas-place">
            <PlanView />
          </div>
        </section>
      </div>
    </main>
  );
}
