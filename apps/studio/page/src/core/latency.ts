// How fast the page answers, kept for tests and for the about box: the newest records of each kind, ms.

export type LatencyKind = 'pointer echo' | 'move to shape' | 'settle' | 'preview' | 'first picture' | 'apply';

const kKept = 500;
const records: Record<LatencyKind, number[]> = {
  'pointer echo': [],
  'move to shape': [],
  settle: [],
  preview: [],
  'first picture': [],
  apply: [],
};

export function note(kind: LatencyKind, milliseconds: number): void {
  const list = records[kind];
  list.push(milliseconds);
  if (list.length > kKept) list.shift();
}

export function latencies(): Readonly<Record<LatencyKind, readonly number[]>> {
  return records;
}

export function clearLatencies(): void {
  for (const list of Object.values(records)) list.length = 0;
}

/** Times of moves that wait for an answer; 0: none waits. */
let moved = 0;
let lastMove = 0;
let handleMoved = 0;
let echoOf = 0;

/** The pointer has moved something; `at` is the time of the event. */
export function noteMove(at: number): void {
  if (moved === 0) moved = at;
  lastMove = at;
  echoOf = at;
}

/** What the pointer moves has been drawn. */
export function noteEcho(now: number): void {
  if (echoOf > 0) note('pointer echo', now - echoOf);
  echoOf = 0;
}

/** A shape of a drag has been drawn. */
export function noteShape(now: number, ofDrag: boolean, settled: boolean): void {
  if (ofDrag && moved > 0) {
    note('move to shape', now - moved);
    moved = 0;
  }
  if (settled && lastMove > 0 && moved === 0) {
    note('settle', now - lastMove);
    lastMove = 0;
  }
}

export function noteHandleMove(): void {
  if (handleMoved === 0) handleMoved = performance.now();
}

export function notePreview(now: number): void {
  if (handleMoved > 0) note('preview', now - handleMoved);
  handleMoved = 0;
}
