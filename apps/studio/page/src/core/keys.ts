// From keys to commands. Written "Ctrl+Shift+Z"; Ctrl means Cmd on a Mac too. Letters are upper case, "Space" and "Plus"
// are spelled out.

import { commands, isEnabled, keysOf, run } from './commands';

export interface KeyPress {
  key: string;
  ctrlKey: boolean;
  metaKey: boolean;
  shiftKey: boolean;
  altKey: boolean;
}

/** The name of a press, or "" for a modifier alone. */
export function chordOf(press: KeyPress): string {
  const { key } = press;
  if (['Control', 'Shift', 'Alt', 'Meta', 'AltGraph', 'Dead', 'Unidentified'].includes(key)) return '';
  const letter = key.length === 1 && key.toLowerCase() !== key.toUpperCase();
  const name = key === ' ' ? 'Space' : key === '+' ? 'Plus' : letter ? key.toUpperCase() : key;
  const parts: string[] = [];
  if (press.ctrlKey || press.metaKey) parts.push('Ctrl');
  if (press.altKey) parts.push('Alt');
  // What Shift makes of a sign ("?") is in the sign; of letters and named keys it is said.
  if (press.shiftKey && (letter || key.length > 1 || key === ' ')) parts.push('Shift');
  parts.push(name);
  return parts.join('+');
}

/** Keys that text fields need for themselves. */
function belongsToText(press: KeyPress, target: unknown): boolean {
  const element = target as { tagName?: string; isContentEditable?: boolean; type?: string } | null;
  const tag = element?.tagName ?? '';
  const writes = element?.isContentEditable === true || tag === 'TEXTAREA' || tag === 'SELECT' || (tag === 'INPUT' && !['checkbox', 'radio', 'range', 'button'].includes(element?.type ?? ''));
  if (writes) return !(press.ctrlKey || press.metaKey) || ['a', 'z', 'y', 'c', 'v', 'x'].includes(press.key.toLowerCase());
  // Buttons, sliders and the like are worked by these.
  const plain = [' ', 'Enter', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End', 'PageUp', 'PageDown'].includes(press.key);
  return plain && (tag === 'BUTTON' || tag === 'INPUT' || tag === 'SUMMARY' || tag === 'A');
}

/** Runs the command that has the keys of a press; says whether there was one. */
export function dispatch(press: KeyPress, target: unknown): boolean {
  const chord = chordOf(press);
  if (chord === '' || belongsToText(press, target)) return false;
  const found = commands().find((c) => keysOf(c).includes(chord) && isEnabled(c));
  return found ? run(found.id) : false;
}
