// Every key by what it does (?): a click on a key takes another one.

import { useState } from 'preact/hooks';
import { announce, commands, keyOverrides, keysOf, type Command } from '../../core/commands';
import { chordOf } from '../../core/keys';
import { holderOf, withKeys, withoutChoice } from '../logic/key_map';
import { keyText } from '../logic/keys';
import { Button } from '../parts/button';
import { closeDialog, Modal } from '../parts/modal';

export function KeySheet() {
  /** id of the command that waits for its new key. */
  const [waiting, setWaiting] = useState('');
  const groups = [...new Set(commands().map((c) => c.group))];
  const changed = Object.keys(keyOverrides.value).length > 0;
  return (
    <Modal
      title="Keys"
      class="wide"
      onClose={() => closeDialog('keys')}
      actions={
        <>
          <p class="soft menu-title">Choose a key, then press another. Escape leaves it as it is, Delete takes it away.</p>
          <Button icon="reset" disabled={!changed} onClick={() => (keyOverrides.value = {})}>
            All as they were
          </Button>
        </>
      }
    >
      <div class="key-groups">
        {groups.map((group) => (
          <section key={group} aria-label={group}>
            <h3>{group}</h3>
            <ul>
              {commands()
                .filter((c) => c.group === group)
                .map((c) => (
                  <KeyRow key={c.id} of={c} waiting={waiting === c.id} onWait={(on) => setWaiting(on ? c.id : '')} />
                ))}
            </ul>
          </section>
        ))}
      </div>
    </Modal>
  );
}

function KeyRow({ of, waiting, onWait }: { of: Command; waiting: boolean; onWait: (on: boolean) => void }) {
  const keys = keysOf(of);
  const own = keyOverrides.value[of.id] !== undefined;
  const pressed = (event: KeyboardEvent) => {
    if (!waiting) return;
    const wanted = chordOf(event);
    if (wanted === '' || wanted === 'Tab' || wanted === 'Shift+Tab') return;
    event.preventDefault();
    event.stopPropagation();
    onWait(false);
    if (wanted === 'Escape') return;
    if (wanted === 'Delete') keyOverrides.value = { ...keyOverrides.peek(), [of.id]: [] };
    else give(of, wanted);
  };
  const shown = keys.map((k) => keyText(k)).join(' or ');
  return (
    <li class="key-row">
      <span>{of.title}</span>
      {own && (
        <Button
          icon="reset"
          class="field-reset"
          label={`Key of ${of.title} as it was`}
          onClick={() => (keyOverrides.value = withoutChoice(keyOverrides.peek(), of.id))}
        />
      )}
      <button
        type="button"
        class="key"
        aria-label={`${of.title}: ${waiting ? 'press a key' : shown || 'no key'}`}
        onClick={() => onWait(true)}
        onBlur={() => onWait(false)}
        onKeyDown={pressed}
      >
        {waiting ? 'press a key' : shown || '–'}
      </button>
    </li>
  );
}

function give(to: Command, keys: string): void {
  const all = commands().map((c) => ({ id: c.id, title: c.title, keys: keysOf(c) }));
  const loser = holderOf(keys, all, to.id);
  keyOverrides.value = withKeys(keyOverrides.peek(), all, to.id, keys);
  announce(`${keyText(keys)} is now ${to.title}.${loser ? ` ${loser.title} has lost it.` : ''}`);
}
