// The one sentence at the foot of the page, always true, from what is known of the engine and the shape.

import type { VerdictEvent } from '../../core/protocol';
import type { ConnectionState } from '../../core/store';
import { counted, durationText, short } from './number_text';
import { sentence } from './words';

export type Tone = 'calm' | 'busy' | 'warn' | 'bad';

export interface VerdictLine {
  tone: Tone;
  /** A full sentence. */
  text: string;
  /** What else is known, in a few words each. */
  details: string[];
}

export interface Known {
  connection: ConnectionState;
  verdict: VerdictEvent | null;
  /** Equilibrium follows edits. */
  running: boolean;
  dragging: boolean;
  /** A structure without a plan. */
  lookOnly: boolean;
  /** The shape on screen is on its way. */
  moving: boolean;
}

export function verdictLine({ connection, verdict, running, dragging, moving, lookOnly }: Known): VerdictLine {
  if (connection === 'lost') {
    return { tone: 'bad', text: 'The engine does not answer; the page tries again by itself. Your work is saved beside the file.', details: [] };
  }
  if (connection === 'connecting') return { tone: 'busy', text: 'Connecting to the engine.', details: [] };
  if (lookOnly && !verdict) return { tone: 'calm', text: 'To look at: this structure is shown as its file says.', details: [] };
  // While the shape is on its way, nothing has ended and nothing is wrong.
  if (moving) return { tone: 'busy', text: dragging ? 'Following the drag.' : 'Settling.', details: [] };
  if (!verdict) return { tone: 'calm', text: 'No shape yet.', details: [] };
  const settledCalmly = verdict.settled && verdict.name === 'stable';
  if (settledCalmly) return settled(verdict, running);
  if (verdict.settled) return { tone: 'warn', text: sentence(verdict.sentence), details: facts(verdict) };
  const kept = verdict.shown === 'last good' ? ' The last good shape is shown.' : '';
  return { tone: 'bad', text: sentence(verdict.sentence) + kept, details: facts(verdict) };
}

function settled(verdict: VerdictEvent, running: boolean): VerdictLine {
  const text = `Settled in ${durationText(verdict.milliseconds)}, ${counted(verdict.iterations, 'iteration')}.`;
  const note = verdict.note === '' ? '' : ` ${sentence(verdict.note)}`;
  return {
    tone: 'calm',
    text: text + note + (running ? '' : ' The shape does not follow edits until you press Space.'),
    details: facts(verdict),
  };
}

function facts(verdict: VerdictEvent): string[] {
  const out = [`residual ${short(verdict.residual_n, 2)} N`];
  const lowest = verdict.lowest_mode_n_per_m;
  if (lowest !== null) out.push(`${verdict.name.replace(/_/g, ' ')} (lowest mode ${short(lowest, 2)} N/m)`);
  return out;
}
