// Edits from panels: refusals come back to the field that asked, drags become one step.

import { useRef } from 'preact/hooks';
import { send } from '../core/connection';
import { Drag } from '../core/drag';
import type { Answer, Constraints, Edit } from '../core/protocol';
import { fault, plan } from '../core/store';

/** One edit whose refusal is shown where it was made. */
export function fieldEdit(change: Edit): Promise<Answer> {
  return send({ do: 'edit', edit: change }, true);
}

/** What a field needs to show its value while it is dragged and to make it one step at the end. */
export function useDragged(make: (value: number) => Edit): {
  onPreview: (value: number) => void;
  onCommit: (value: number) => Promise<Answer | null>;
} {
  const drag = useRef<Drag | null>(null);
  const latest = useRef(make);
  latest.current = make;
  return {
    onPreview: (value) => {
      drag.current ??= new Drag();
      drag.current.update(latest.current(value));
    },
    onCommit: async (value) => {
      const under = drag.current;
      drag.current = null;
      if (!under) return fieldEdit(latest.current(value));
      under.update(latest.current(value));
      const answer = await under.end();
      // The field itself says why; no need to say it twice.
      if (answer && fault.peek() === answer.error) fault.value = null;
      return answer;
    },
  };
}

/** Changes some of the constraints. */
export function setConstraints(change: (now: Constraints) => Partial<Constraints>): void {
  const now = plan.peek()?.constraints;
  if (now) void send({ do: 'edit', edit: { name: 'set_constraints', ...change(now) } });
}
