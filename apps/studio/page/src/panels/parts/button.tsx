// Buttons: plain ones with a name, and those of the command list.

import type { ComponentChildren, TargetedMouseEvent } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { command, isEnabled, keysOf, run } from '../../core/commands';
import { Icon, isIconName, type IconName } from './icon';
import { ariaKeys, keyText } from '../logic/keys';

interface ButtonProps {
  icon?: IconName;
  /** Said by screen readers and shown on hover; for buttons with a text only where it needs more words. */
  label?: string;
  /** Shown on hover instead of the label. */
  hint?: string;
  class?: string;
  pressed?: boolean;
  disabled?: boolean;
  onClick: (event: TargetedMouseEvent<HTMLButtonElement>) => void;
  children?: ComponentChildren;
  /** Keys that do the same. */
  keys?: readonly string[];
}

export function Button(props: ButtonProps) {
  const { icon, label, children, pressed, disabled, onClick, keys = [] } = props;
  const bare = children === undefined;
  const said = props.hint ?? label;
  const shown = keys[0] ? `${said ?? ''} (${keyText(keys[0])})` : said;
  const element = useRef<HTMLButtonElement>(null);
  // A disabled button that keeps the focus would swallow every key.
  useEffect(() => {
    if (disabled && document.activeElement === element.current) element.current?.blur();
  }, [disabled]);
  return (
    <button
      ref={element}
      type="button"
      class={`button ${bare ? 'icon-only plain' : ''} ${props.class ?? ''}`}
      aria-label={bare ? label : undefined}
      aria-pressed={pressed}
      aria-keyshortcuts={ariaKeys(keys)}
      title={shown}
      disabled={disabled}
      onClick={onClick}
    >
      {icon && <Icon name={icon} />}
      {children}
    </button>
  );
}

/** A button for a command of the registry; absent where the command is. */
export function CommandButton(props: { id: string; text?: string; icon?: IconName; class?: string; hint?: string }) {
  const found = command(props.id);
  if (!found) return null;
  const icon = props.icon ?? (isIconName(found.icon) ? found.icon : undefined);
  return (
    <Button
      icon={icon}
      label={found.title}
      hint={props.hint}
      class={props.class}
      pressed={found.checked?.()}
      disabled={!isEnabled(found)}
      keys={keysOf(found)}
      onClick={() => run(found.id)}
    >
      {props.text ?? (icon ? undefined : found.title)}
    </Button>
  );
}
