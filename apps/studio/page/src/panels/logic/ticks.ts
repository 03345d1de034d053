// Where a scale is marked, and how often values fall between its marks.

/** Round numbers within low..high, about `wanted` of them. */
export function ticks(low: number, high: number, wanted = 5): number[] {
  if (!(high > low)) return [low];
  const raw = (high - low) / wanted;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((f) => f * power).find((s) => s >= raw) ?? 10 * power;
  const digits = Math.max(0, -Math.floor(Math.log10(step)) + 2);
  const out: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    out.push(Number((k * step).toFixed(Math.min(digits, 20))));
  }
  return out;
}

/** Digits after the point that say every tick exactly. */
export function tickDigits(marks: readonly number[]): number {
  for (let digits = 0; digits < 8; ++digits) {
    if (marks.every((mark) => Math.abs(Number(mark.toFixed(digits)) - mark) < 1e-9 * Math.max(1, Math.abs(mark)))) return digits;
  }
  return 8;
}

/** Number of values in each of `count` equal parts of low..high; what is outside counts in the first or last. */
export function histogram(values: ArrayLike<number>, low: number, high: number, count: number): number[] {
  const bins = Array.from({ length: count }, () => 0);
  if (!(high > low)) return bins;
  for (let i = 0; i < values.length; ++i) {
    const value = values[i];
    if (value === undefined || !Number.isFinite(value)) continue;
    const bin = Math.floor(((value - low) / (high - low)) * count);
    const at = Math.max(0, Math.min(count - 1, bin));
    bins[at] = (bins[at] ?? 0) + 1;
  }
  return bins;
}
