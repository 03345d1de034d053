// What several things have in common.

export type Common<T> = { kind: 'none' } | { kind: 'same'; value: T } | { kind: 'mixed' };

/** The value that all share, within `tolerance` for numbers. */
export function common<T>(values: readonly T[], tolerance = 1e-9): Common<T> {
  const [first, ...rest] = values;
  if (first === undefined) return { kind: 'none' };
  const same = rest.every((value) =>
    typeof value === 'number' && typeof first === 'number' ? Math.abs(value - first) <= tolerance : value === first,
  );
  return same ? { kind: 'same', value: first } : { kind: 'mixed' };
}
