// Dragging points of the plan: drawn at once where the pointer is, sent as a drag, one step of history at its end.

import { Drag } from '../core/drag';
import { noteMove } from '../core/latency';
import type { Edit, PlanEvent, Vec2 } from '../core/protocol';
import { localMoves, plan } from '../core/store';
import { withImages } from '../core/symmetry';

export class PointDrag {
  private readonly drag = new Drag();
  private readonly places: ReadonlyMap<string, Vec2>;

  /** `grabbed`: where what the pointer holds was at the start. */
  constructor(
    private readonly start: PlanEvent,
    readonly points: readonly string[],
    private readonly grabbed: Vec2,
  ) {
    this.places = new Map(start.points.map((p) => [p.name, p.at_mm]));
  }

  to(at: Vec2, time: number): void {
    const by: Vec2 = [at[0] - this.grabbed[0], at[1] - this.grabbed[1]];
    const own = this.points.map((point) => {
      const from = this.places.get(point) ?? [0, 0];
      return { point, to_mm: [from[0] + by[0], from[1] + by[1]] as Vec2 };
    });
    const moves = withImages(this.start, own);
    noteMove(time);
    localMoves.value = new Map(moves.map((m) => [m.point, m.to_mm]));
    this.drag.update({ name: 'move_points', moves } satisfies Edit);
  }

  /** The echo stays until the engine has answered: nothing jumps back in between. */
  async end(): Promise<void> {
    const shown = localMoves.peek();
    await this.drag.end();
    if (localMoves.peek() === shown) localMoves.value = new Map();
  }

  cancel(): void {
    this.drag.cancel();
    localMoves.value = new Map();
  }
}

/** Moves points once, as arrow keys do. */
export function movesNow(moves: { point: string; to_mm: Vec2 }[]): { point: string; to_mm: Vec2 }[] {
  const now = plan.peek();
  return now ? withImages(now, moves) : moves;
}
