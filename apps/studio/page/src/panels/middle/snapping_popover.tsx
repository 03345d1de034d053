// What points of the plan snap to.

import { gridStep, snapping } from '../../core/store';
import { Switch } from '../parts/choice';
import { Field } from '../parts/field';
import { Popover } from '../parts/popover';

const kinds: ReadonlyArray<{ name: keyof typeof snapping.value; title: string }> = [
  { name: 'grid', title: 'Grid' },
  { name: 'points', title: 'Points' },
  { name: 'rods', title: 'Rods' },
  { name: 'angle', title: 'Angles of 15°' },
  { name: 'symmetry', title: 'Mirror line' },
];

export function SnappingPopover() {
  return (
    <Popover role="dialog" label="Snapping" icon="snap">
      {() => (
        <div class="stack">
          <fieldset class="switches">
            <legend>Points snap to</legend>
            {kinds.map(({ name, title }) => (
              <Switch
                key={name}
                label={title}
                checked={snapping.value[name]}
                onSwitch={(on) => (snapping.value = { ...snapping.peek(), [name]: on })}
              />
            ))}
          </fieldset>
          <Field
            label="Grid"
            unit="mm"
            digits={2}
            step={1}
            value={gridStep.value}
            onCommit={(step) => {
              if (step > 0) gridStep.value = step;
              return null;
            }}
          />
          <p class="small soft">Alt suspends snapping while you drag.</p>
        </div>
      )}
    </Popover>
  );
}
