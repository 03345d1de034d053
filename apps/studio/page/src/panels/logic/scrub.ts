// A run of changes of one number that becomes one step: while a slider moves, or while an arrow key is pressed again and
// again. It ends on release, or when nothing came for a while.

export interface Target {
  /** The value as it would be now; called often. */
  preview: (value: number) => void;
  /** The value at the end of the run; called once. */
  commit: (value: number) => void;
}

export class Scrub {
  private timer: ReturnType<typeof setTimeout> | undefined;
  private last: number | undefined;

  constructor(
    private readonly target: () => Target,
    private readonly patience_ms = 600,
  ) {}

  /** The value that was previewed and is not yet committed. */
  get pending(): number | undefined {
    return this.last;
  }

  move(value: number): void {
    clearTimeout(this.timer);
    this.last = value;
    this.target().preview(value);
  }

  /** As move, and ends by itself when no further step comes. */
  step(value: number): void {
    this.move(value);
    this.timer = setTimeout(() => this.end(), this.patience_ms);
  }

  end(): void {
    clearTimeout(this.timer);
    const value = this.last;
    this.last = undefined;
    if (value !== undefined) this.target().commit(value);
  }
}
