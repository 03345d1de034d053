// Search over everything that can be done (Ctrl+K): arrows choose, Enter does it.

import { useMemo, useRef, useState } from 'preact/hooks';
import { commands, isEnabled, keysOf, run } from '../../core/commands';
import { keyText } from '../logic/keys';
import { matches } from '../logic/match';
import { closeDialog, Modal } from '../parts/modal';

const kMost = 60;

export function CommandSearch() {
  const [query, setQuery] = useState('');
  const [at, setAt] = useState(0);
  const list = useRef<HTMLUListElement>(null);
  const all = commands();
  const found = useMemo(
    () => matches(query, all, (c) => c.title, (c) => `${c.group} ${c.help ?? ''}`).slice(0, kMost),
    [query, all],
  );
  const close = () => closeDialog('commands');
  const take = (index: number) => {
    const chosen = found[index];
    if (!chosen || !isEnabled(chosen)) return;
    close();
    run(chosen.id);
  };
  const go = (to: number) => {
    const next = Math.max(0, Math.min(found.length - 1, to));
    setAt(next);
    list.current?.children[next]?.scrollIntoView({ block: 'nearest' });
  };
  const pressed = (event: KeyboardEvent) => {
    event.stopPropagation();
    if (event.key === 'ArrowDown') go(at + 1);
    else if (event.key === 'ArrowUp') go(at - 1);
    else if (event.key === 'PageDown') go(at + 10);
    else if (event.key === 'PageUp') go(at - 10);
    else if (event.key === 'Enter') take(at);
    else return;
    event.preventDefault();
  };
  return (
    <Modal title="What do you want to do?" class="search" onClose={close}>
      <input
        class="entry search-entry"
        type="text"
        role="combobox"
        aria-label="Search commands"
        aria-expanded="true"
        aria-controls="command-list"
        aria-activedescendant={found[at] ? `command-${at}` : undefined}
        aria-autocomplete="list"
        autocomplete="off"
        spellcheck={false}
        placeholder="Undo, strain, mirror, export ..."
        autofocus
        value={query}
        onInput={(event) => {
          setQuery(event.currentTarget.value);
          go(0);
        }}
        onKeyDown={pressed}
      />
      <ul ref={list} id="command-list" class="search-list" role="listbox" aria-label="Commands">
        {found.map((c, k) => (
          <li
            key={c.id}
            id={`command-${k}`}
            class="search-row"
            role="option"
            aria-selected={k === at}
            aria-disabled={!isEnabled(c)}
            onPointerMove={() => setAt(k)}
            onClick={() => take(k)}
          >
            <span class="soft small search-group">{c.group}</span>
            <span class="menu-title">
              {c.title}
              {c.checked?.() && <span class="soft"> (on)</span>}
            </span>
            {keysOf(c).map((keys) => (
              <kbd key={keys}>{keyText(keys)}</kbd>
            ))}
          </li>
        ))}
      </ul>
      {found.length === 0 && (
        <p class="soft" role="status">
          Nothing is called that. Try another word, or look through the menu at the top left.
        </p>
      )}
    </Modal>
  );
}
