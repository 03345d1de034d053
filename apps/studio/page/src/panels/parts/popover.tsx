// A button with a panel that opens beneath it, on the native popover: a click outside or Escape closes it.

import type { ComponentChildren } from 'preact';
import { useId, useRef, useState } from 'preact/hooks';
import { Icon, type IconName } from './icon';

interface PopoverProps {
  label: string;
  icon?: IconName;
  /** What the button shows; its icon alone without. */
  text?: ComponentChildren;
  class?: string;
  role: 'dialog' | 'menu';
  /** Gets a function that closes the panel. Rendered only while it is open. */
  children: (close: () => void) => ComponentChildren;
}

export function Popover({ label, icon, text, class: extra = '', role, children }: PopoverProps) {
  const id = useId();
  const button = useRef<HTMLButtonElement>(null);
  const panel = useRef<HTMLDivElement>(null);
  const [open, setOpen] = useState(false);
  const close = () => {
    panel.current?.hidePopover();
    button.current?.focus();
  };
  return (
    <>
      <button
        ref={button}
        type="button"
        class={`button plain ${text === undefined ? 'icon-only' : ''} ${extra}`}
        aria-label={text === undefined ? label : undefined}
        aria-haspopup={role}
        aria-expanded={open}
        title={label}
        popovertarget={id}
      >
        {icon && <Icon name={icon} />}
        {text}
      </button>
      <div
        ref={panel}
        id={id}
        class={`popover popover-${role}`}
        popover="auto"
        role={role === 'dialog' ? 'dialog' : undefined}
        aria-label={role === 'dialog' ? label : undefined}
        onToggle={(event) => {
          const shown = event.newState === 'open';
          setOpen(shown);
          if (shown && button.current && panel.current) place(panel.current, button.current);
        }}
      >
        {open && children(close)}
      </div>
    </>
  );
}

/** Puts a panel below a button, or above it where there is no room, inside the window. */
export function place(panel: HTMLElement, button: HTMLElement): void {
  const at = button.getBoundingClientRect();
  const settle = () => {
    const { width, height } = panel.getBoundingClientRect();
    const left = Math.max(4, Math.min(at.left, innerWidth - width - 4));
    const below = at.bottom + 4;
    const top = below + height <= innerHeight - 4 ? below : Math.max(4, at.top - height - 4);
    panel.style.left = `${left}px`;
    panel.style.top = `${top}px`;
  };
  settle();
  // What it shows is drawn after it has opened.
  requestAnimationFrame(settle);
}
