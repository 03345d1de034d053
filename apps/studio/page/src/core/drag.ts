// A drag: the edit as it would be now, sent again and again, and one step of history at its end. At most one request is
// in flight; of those that wait only the newest is sent. Sliders of panels and tools of the plan use the same class.

import { send } from './connection';
import type { Answer, Edit } from './protocol';
import { dragging } from './store';

let nextNumber = 1;

export class Drag {
  readonly number = nextNumber++;
  private flying = false;
  private next: Edit | null = null;
  private last: Edit | null = null;
  private over = false;

  /** The edit as it would be now. */
  update(edit: Edit): void {
    if (this.over) return;
    dragging.value = this.number;
    this.last = edit;
    this.next = edit;
    void this.pump();
  }

  /** Makes the last edit one step; nothing happens when there was none. */
  async end(): Promise<Answer | null> {
    this.over = true;
    this.next = null;
    if (dragging.peek() === this.number) dragging.value = 0;
    return this.last ? send({ do: 'drag_end', drag: this.number, edit: this.last }) : null;
  }

  /** As if it had not been. */
  cancel(): void {
    this.over = true;
    this.next = null;
    if (dragging.peek() === this.number) dragging.value = 0;
    if (this.last) void send({ do: 'drag_cancel', drag: this.number });
  }

  private async pump(): Promise<void> {
    if (this.flying) return;
    this.flying = true;
    while (this.next) {
      const edit = this.next;
      this.next = null;
      const answer = await send({ do: 'drag', drag: this.number, edit });
      if (!answer.ok) break;
    }
    this.flying = false;
  }
}
