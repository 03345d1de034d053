// How keys are written for people (core/keys.ts says how commands write them).

/** "Ctrl+Shift+Z" as this machine's keyboards say it. */
export function keyText(keys: string, mac = onMac()): string {
  const parts = keys.split('+');
  const arrows: Readonly<Record<string, string>> = { Plus: '+', ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓' };
  const signs: Readonly<Record<string, string>> = { ...arrows, Ctrl: '⌘', Shift: '⇧', Alt: '⌥', Delete: '⌦', Enter: '↩' };
  if (mac) return parts.map((part) => signs[part] ?? part).join('');
  return parts.map((part) => arrows[part] ?? part).join('+');
}

/** As aria-keyshortcuts wants it. */
export function ariaKeys(keys: readonly string[]): string | undefined {
  if (keys.length === 0) return undefined;
  return keys.map((k) => k.replace('Ctrl', onMac() ? 'Meta' : 'Control')).join(' ');
}

function onMac(): boolean {
  return typeof navigator !== 'undefined' && /Mac|iPhone|iPad/.test(navigator.platform);
}
