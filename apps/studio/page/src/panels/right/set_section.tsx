// Keeps what is selected under a name; the tree lists it.

import { signal } from '@preact/signals';
import { announce } from '../../core/commands';
import { size } from '../../core/selection';
import { namedSets, selection } from '../../core/store';
import { keepPlainKeys } from '../parts/field';
import { Button } from '../parts/button';

const name = signal('');

export function KeepAsSet() {
  if (size(selection.value) < 2) return null;
  const keep = () => {
    const called = name.peek().trim();
    if (called === '') return;
    namedSets.value = { ...namedSets.peek(), [called]: selection.peek() };
    name.value = '';
    announce(`The selection is kept as ${called}.`);
  };
  return (
    <div class="set-entry">
      <input
        class="entry"
        type="text"
        aria-label="Name for this selection"
        placeholder="Name for this selection"
        autocomplete="off"
        value={name.value}
        onInput={(event) => (name.value = event.currentTarget.value)}
        onKeyDown={(event) => {
          keepPlainKeys(event);
          if (event.key === 'Enter') keep();
        }}
      />
      <Button icon="layers" label="Keep the selection under this name; the tree lists it" disabled={name.value.trim() === ''} onClick={keep}>
        Keep
      </Button>
    </div>
  );
}
