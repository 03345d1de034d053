// How keys are written for people, and read from the keyboard.

/** "Ctrl+Shift+Z" as this machine's keyboards say it. */
export function keyText(keys: string, mac = onMac()): string {
  const parts = splitKeys(keys);
  if (!mac) return parts.join('+');
  const signs: Readonly<Record<string, string>> = { Ctrl: '⌘', Shift: '⇧', Alt: '⌥', Delete: '⌦', Enter: '↩' };
  return parts.map((part) => signs[part] ?? part).join('');
}

/** As aria-keyshortcuts wants it. */
export function ariaKeys(keys: readonly string[]): string | undefined {
  if (keys.length === 0) return undefined;
  return keys.map((k) => splitKeys(k).join('+').replace('Ctrl', onMac() ? 'Meta' : 'Control')).join(' ');
}

/** What was pressed, written as commands write it; empty while only Ctrl, Shift or the like are down. */
export function pressedKeys(event: Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey'>): string {
  if (['Control', 'Shift', 'Alt', 'Meta', 'AltGraph', 'CapsLock', 'Dead'].includes(event.key)) return '';
  const named: Readonly<Record<string, string>> = { ' ': 'Space', Esc: 'Escape', Del: 'Delete' };
  const single = event.key.length === 1;
  const key = named[event.key] ?? (single ? event.key.toUpperCase() : event.key);
  const letter = single && /[\p{L}\p{N}]/u.test(event.key);
  const parts: string[] = [];
  if (event.ctrlKey || event.metaKey) parts.push('Ctrl');
  if (event.altKey) parts.push('Alt');
  if (event.shiftKey && (letter || !single || event.key === ' ')) parts.push('Shift');
  return [...parts, key].join('+');
}

function splitKeys(keys: string): string[] {
  return keys === '+' ? ['+'] : keys.split(/\+(?=.)/);
}

function onMac(): boolean {
  return typeof navigator !== 'undefined' && /Mac|iPhone|iPad/.test(navigator.platform);
}
