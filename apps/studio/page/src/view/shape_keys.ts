// Typed numbers for the handle: G, R or S chooses what, X, Y or Z along which axis, digits how much, Enter takes it over.

import { readQuantity } from '../panels/logic/quantity';
import { moveHandle } from '../core/handles';
import type { HandleMove, Vec3 } from '../core/protocol';
import * as store from '../core/store';
import { typed } from './local';

let axis: 0 | 1 | 2 | -1 = -1;

/** The pose that the typed text means, or null when it means none yet. */
export function typedPose(text: string, before: HandleMove, kind: store.GizmoKind, along: number): HandleMove | null {
  const reading = readQuantity(text, kind === 'move' ? 'mm' : kind === 'rotate' ? '°' : '');
  if (!('value' in reading)) return null;
  const { value } = reading;
  if (kind === 'scale') return value > 0 ? { ...before, scale: value } : null;
  const triple: Vec3 = kind === 'move' ? [...before.move_mm] : [...before.turn_deg];
  triple[along < 0 ? 2 : along] = value;
  return kind === 'move' ? { ...before, move_mm: triple } : { ...before, turn_deg: triple };
}

/** Takes a key while a handle is held; says whether it was one of its own. */
export function shapeKey(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const letter = event.key.toLowerCase();
  if (letter === 'g' || letter === 'r' || letter === 's') {
    store.gizmoKind.value = letter === 'g' ? 'move' : letter === 'r' ? 'rotate' : 'scale';
    axis = -1;
    typed.value = prompt('');
    return true;
  }
  if (letter === 'x' || letter === 'y' || letter === 'z') {
    axis = 'xyz'.indexOf(letter) as 0 | 1 | 2;
    typed.value = prompt('');
    return true;
  }
  // Digits are views until one of these letters has asked for a number.
  if (typed.peek() === '') return false;
  if (/^[\d.,\-+*/()% ]$/.test(event.key)) return extend(digits() + event.key);
  if (event.key === 'Backspace') return extend(digits().slice(0, -1));
  return false;
}

export function endTyping(): void {
  typed.value = '';
  axis = -1;
}

function digits(): string {
  return typed.peek().split('\u2009').at(1) ?? '';
}

function prompt(text: string): string {
  const name = { move: 'move', rotate: 'turn', scale: 'scale' }[store.gizmoKind.peek()];
  const along = store.gizmoKind.peek() === 'scale' ? '' : ` ${'xyz'[axis < 0 ? 2 : axis]}`;
  return `${name}${along}\u2009${text}`;
}

function extend(text: string): boolean {
  typed.value = prompt(text);
  const pose = typedPose(text, store.handlePose.peek(), store.gizmoKind.peek(), axis);
  if (pose) moveHandle(pose);
  return true;
}
