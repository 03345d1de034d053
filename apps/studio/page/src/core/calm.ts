// Events come with every step of a drag. Views follow each of them, panels a few a second: repainting text sixty times a
// second is what a machine without a graphics card has no time for, and nobody reads so fast.

import type { Signal } from '@preact/signals-core';

const kPeriodMs = 200;

/** Writes a signal at once, or, while `calm` says so, at most five times a second; the last value always arrives. */
export class CalmWriter<T> {
  private last = -Infinity;
  private waiting: { value: T } | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly signal: Signal<T>,
    private readonly calm: () => boolean,
  ) {}

  write(value: T): void {
    const wait = this.calm() ? this.last + kPeriodMs - performance.now() : 0;
    if (wait <= 0) {
      this.put(value);
      return;
    }
    this.waiting = { value };
    this.timer ??= setTimeout(() => this.flush(), wait);
  }

  /** Writes what still waits. */
  flush(): void {
    if (this.waiting) this.put(this.waiting.value);
  }

  private put(value: T): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.waiting = null;
    this.last = performance.now();
    this.signal.value = value;
  }
}
