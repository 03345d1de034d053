// Entries of a menu: arrows, Home, End and first letters move, Enter and Space take.

import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { isEnabled, keysOf, run, type Command } from '../../core/commands';
import { keyText } from '../logic/keys';
import { Icon } from './icon';

interface MenuListProps {
  label: string;
  /** Takes the focus when it appears. */
  autoFocus?: boolean;
  /** ArrowLeft, where this is a menu beside another. */
  onBack?: () => void;
  onClose: () => void;
  children: ComponentChildren;
}

export function MenuList({ label, autoFocus, onBack, onClose, children }: MenuListProps) {
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (autoFocus) entriesOf(list.current)[0]?.focus();
  }, []);
  const pressed = (event: KeyboardEvent) => {
    const entries = entriesOf(list.current);
    const to = wanted(event.key, entries, entries.indexOf(document.activeElement as HTMLElement));
    if (to) to.focus();
    else if (event.key === 'ArrowLeft' && onBack) onBack();
    else if (event.key === 'Tab') onClose();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div ref={list} class="menu" role="menu" aria-label={label} onKeyDown={pressed}>
      {children}
    </div>
  );
}

function entriesOf(list: HTMLElement | null): HTMLElement[] {
  return [...(list?.querySelectorAll<HTMLElement>('[role^="menuitem"]') ?? [])];
}

/** The entry that a key leads to. */
function wanted(key: string, entries: HTMLElement[], at: number): HTMLElement | undefined {
  const count = entries.length;
  if (key === 'ArrowDown') return entries[(at + 1) % count];
  if (key === 'ArrowUp') return entries[(at - 1 + count) % count];
  if (key === 'Home') return entries[0];
  if (key === 'End') return entries[count - 1];
  if (key.length !== 1 || key === ' ') return undefined;
  const from = [...entries.slice(at + 1), ...entries.slice(0, at + 1)];
  return from.find((entry) => entry.textContent?.trim().toLowerCase().startsWith(key.toLowerCase()));
}

interface EntryProps {
  title: string;
  aside?: string;
  checked?: boolean;
  disabled?: boolean;
  onTake: () => void;
}

export function MenuEntry({ title, aside, checked, disabled, onTake }: EntryProps) {
  return (
    <button
      type="button"
      class="menu-entry"
      role={checked === undefined ? 'menuitem' : 'menuitemcheckbox'}
      aria-checked={checked}
      aria-disabled={disabled}
      tabIndex={-1}
      onPointerMove={(event) => event.currentTarget.focus({ preventScroll: true })}
      onClick={() => {
        if (!disabled) onTake();
      }}
    >
      <span class="menu-mark">{checked && <Icon name="check" />}</span>
      <span class="menu-title">{title}</span>
      {aside !== undefined && <span class="menu-keys">{aside}</span>}
    </button>
  );
}

/** A command of the registry as an entry. */
export function CommandEntry({ of, onTaken }: { of: Command; onTaken: () => void }) {
  const keys = keysOf(of)[0];
  return (
    <MenuEntry
      title={of.title}
      aside={keys ? keyText(keys) : undefined}
      checked={of.checked?.()}
      disabled={!isEnabled(of)}
      onTake={() => {
        onTaken();
        run(of.id);
      }}
    />
  );
}
