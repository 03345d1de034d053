// Opening, saving and beginning anew, with what has to be asked before.

import { batch, computed, signal } from '@preact/signals';
import { announce } from '../core/commands';
import { send } from '../core/connection';
import type { Answer, EngineFault, Request } from '../core/protocol';
import { emptySelection } from '../core/selection';
import { dialog, fault, fit, history, modes, project, selection, shownMode } from '../core/store';

/** What waits for a word about unsaved changes; null: nothing. */
export const leaving = signal<Request | null>(null);

/** Why the last save would have lost another file; null: it would not. */
export const saveRefusal = signal<EngineFault | null>(null);

export function openFile(what: { file: string } | { design: string }): Promise<void> {
  return leaveFor({ do: 'open', ...what });
}

export function beginWith(template: string): Promise<void> {
  return leaveFor({ do: 'new', template });
}

/** Goes on with what has waited, after saving where that is wanted. */
export async function leave(how: 'save' | 'drop'): Promise<void> {
  const waiting = leaving.peek();
  leaving.value = null;
  if (!waiting) return;
  if (how === 'save') {
    const answer = await save();
    if (!answer?.ok) return;
  }
  await go(waiting);
}

/** Writes the file; asks for a name where there is none yet, and what to do where another file would be lost. */
export async function save(file?: string, replace = false): Promise<Answer | null> {
  saveRefusal.value = null;
  if (!file && !project.peek()?.file) {
    dialog.value = 'save';
    return null;
  }
  const answer = await send({ do: 'save', ...(file && { file }), ...(replace && { replace }) }, true);
  if (answer.ok) {
    announce(`Saved ${file ?? project.peek()?.file ?? ''}.`);
  } else if (answer.error?.code === 'conflict') {
    saveRefusal.value = answer.error;
    dialog.value = 'save';
  } else {
    fault.value = answer.error ?? null;
  }
  return answer;
}

/** There is work that no file holds: what was only opened and not touched needs no saving. */
export const dirty = computed(() => {
  const { at, saved_at } = history.value ?? { at: 0, saved_at: -1 };
  return project.value?.kind === 'plan' && !project.value.saved && (at > 0 || saved_at > 0);
});

async function leaveFor(request: Request): Promise<void> {
  if (dirty.peek()) leaving.value = request;
  else await go(request);
}

async function go(request: Request): Promise<void> {
  // The shape shows itself while it settles; the answer comes after that.
  const from = dialog.peek();
  if (from === 'start') dialog.value = '';
  const answer = await send(request);
  if (!answer.ok) {
    if (project.peek()?.kind === 'none') dialog.value = from;
    return;
  }
  // Found for another design.
  batch(() => {
    modes.value = null;
    shownMode.value = -1;
    fit.value = null;
    selection.value = emptySelection;
  });
}
