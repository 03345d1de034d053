// Draw, Explore, Shape, Make: the order of work. They change tools and inspector, never the view or the selection.

import { run } from '../../core/commands';
import { workMode, type WorkMode } from '../../core/store';
import { sideShown } from '../layout_state';

export const workModes: ReadonlyArray<{ mode: WorkMode; title: string; help: string }> = [
  { mode: 'draw', title: 'Draw', help: 'Draw rods and fabric in the plan' },
  { mode: 'explore', title: 'Explore', help: 'See what the shape would do most easily' },
  { mode: 'shape', title: 'Shape', help: 'Pull the shape where you want it' },
  { mode: 'make', title: 'Make', help: 'Check it and write files' },
];

export function ModeTabs() {
  const take = (mode: WorkMode) => {
    if (!run(`mode.${mode}`)) workMode.value = mode;
  };
  const pressed = (event: KeyboardEvent) => {
    const at = workModes.findIndex((m) => m.mode === workMode.value);
    const steps: Readonly<Record<string, number>> = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: workModes.length - 1 };
    const to = steps[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const next = workModes[(to + workModes.length) % workModes.length];
    take(next.mode);
    document.getElementById(`tab-${next.mode}`)?.focus();
  };
  return (
    <div class="modes" role="tablist" aria-label="Mode of work" onKeyDown={pressed}>
      {workModes.map(({ mode, title, help }) => (
        <button
          key={mode}
          id={`tab-${mode}`}
          type="button"
          class="tab"
          role="tab"
          aria-selected={workMode.value === mode}
          aria-controls={sideShown('inspector') ? 'inspector' : undefined}
          tabIndex={workMode.value === mode ? 0 : -1}
          title={help}
          onClick={() => take(mode)}
        >
          {title}
        </button>
      ))}
    </div>
  );
}
