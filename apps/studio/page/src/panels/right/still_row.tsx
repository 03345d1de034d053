// What stays where it is while something else is pulled.

import { emptySelection, isEmpty, size } from '../../core/selection';
import { selection, still } from '../../core/store';
import { counted } from '../logic/number_text';
import { Button, CommandButton } from '../parts/button';

export function StillRow() {
  const held = size(still.value);
  if (held === 0 && isEmpty(selection.value)) return null;
  return (
    <div class="row">
      <CommandButton id="shape.still" text="Hold still" />
      {held > 0 && (
        <>
          <span class="small soft">{counted(held, 'part stays', 'parts stay')}</span>
          <Button onClick={() => (still.value = emptySelection)}>Let all go</Button>
        </>
      )}
    </div>
  );
}
