// What the hand holds: the tools of the mode, what the view shows, and whether the shape follows.

import { run } from '../../core/commands';
import { activeTool, gizmoKind, planDock, project, running, toolHint, workMode } from '../../core/store';
import { tools } from '../../tools/index';
import { Button, CommandButton } from '../parts/button';
import { isIconName, type IconName } from '../parts/icon';
import { ViewPopover } from './view_popover';

const gizmos: ReadonlyArray<{ kind: 'move' | 'rotate' | 'scale'; icon: IconName; label: string }> = [
  { kind: 'move', icon: 'move-3d', label: 'Move the handle' },
  { kind: 'rotate', icon: 'rotate', label: 'Turn the handle' },
  { kind: 'scale', icon: 'scale', label: 'Scale the handle' },
];

export function ToolStrip() {
  const looking = project.value?.kind === 'structure';
  return (
    <div class="strip" role="group" aria-label="Tools">
      <div class="strip-tools">
        {tools
          .filter((tool) => tool.modes.includes(workMode.value) && (!looking || tool.id === 'select' || tool.id === 'lasso'))
          .map((tool) => (
            <Button
              key={tool.id}
              icon={isIconName(tool.icon) ? tool.icon : 'select'}
              label={tool.title}
              keys={tool.keys}
              pressed={activeTool.value === tool.id}
              onClick={() => run(`tool.${tool.id}`)}
            />
          ))}
        {workMode.value === 'shape' &&
          gizmos.map(({ kind, icon, label }) => (
            <Button key={kind} icon={icon} label={label} pressed={gizmoKind.value === kind} onClick={() => (gizmoKind.value = kind)} />
          ))}
      </div>
      <p class="hint soft">{toolHint.value}</p>
      <div class="strip-tools">
        {planDock.value === 'hidden' && !looking && (
          <Button icon="panel-bottom" label="Show the plan" onClick={() => (planDock.value = 'below')}>
            Plan
          </Button>
        )}
        <CommandButton id="view.fit" icon="fit" />
        <ViewPopover />
        {!looking && <Following />}
      </div>
    </div>
  );
}

/** Whether the shape follows every edit. */
function Following() {
  return (
    <Button
      icon={running.value ? 'pause' : 'play'}
      label={running.value ? 'Hold: the shape waits' : 'Run: the shape follows every edit'}
      pressed={!running.value}
      onClick={() => run('solve.toggle')}
    >
      {running.value ? 'Live' : 'On hold'}
    </Button>
  );
}
