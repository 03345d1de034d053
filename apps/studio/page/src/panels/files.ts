// Opening, saving and beginning anew, with what has to be asked before.

import { signal } from '@preact/signals';
import { announce } from '../core/commands';
import { send } from '../core/connection';
import type { Answer, Request } from '../core/protocol';
import { dialog, project } from '../core/store';

/** What waits for a word about unsaved changes; null: nothing. */
export const leaving = signal<Request | null>(null);

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

/** Writes the file; asks for a name where there is none yet. */
export async function save(file?: string): Promise<Answer | null> {
  if (!file && !project.peek()?.file) {
    dialog.value = 'save';
    return null;
  }
  const answer = await send(file ? { do: 'save', file } : { do: 'save' });
  if (answer.ok) announce(`Saved ${file ?? project.peek()?.file ?? ''}.`);
  return answer;
}

async function leaveFor(request: Request): Promise<void> {
  if (project.peek() && !project.peek()?.saved) leaving.value = request;
  else await go(request);
}

async function go(request: Request): Promise<void> {
  const answer = await send(request);
  if (answer.ok && dialog.peek() === 'start') dialog.value = '';
}
