// Taking hold of the shape: the soft selection, its wanted place, the request for the linear answer (at most one in
// flight, the newest wins), accept and cancel.

import { send } from './connection';
import { restPose } from './gizmo';
import { noteHandleMove } from './latency';
import type { HandleAnswer, HandleMove, Vec3 } from './protocol';
import { stillBeside } from './still';
import * as store from './store';

let flying = false;
let next: HandleMove | null = null;
let beginning = 0;

/** Takes hold of what is selected; lets go when nothing is. */
export async function beginHandle(): Promise<void> {
  const selection = store.selection.peek();
  const mine = ++beginning;
  next = null;
  store.handlePose.value = restPose;
  store.preview.value = null;
  if (selection.points.size + selection.nodes.size === 0) {
    store.handleCenter.value = null;
    if (store.handle.peek()?.active) void send({ do: 'handle_cancel' }, true);
    return;
  }
  const part = selection.nodes.size > 0 ? { nodes: [...selection.nodes] } : { points: [...selection.points] };
  // Where nothing can be held yet (the shape has not settled) the selection waits for it without a word.
  const held = stillBeside(selection);
  const answer = await send({ do: 'handle_begin', ...part, ...(held.length > 0 && { held }), radius_mm: store.softRadius.peek() }, true);
  if (mine !== beginning) return;
  store.handleCenter.value = answer.ok ? (answer as unknown as HandleAnswer).center_mm : null;
}

/** The wanted place since the handle was taken. */
export function moveHandle(pose: HandleMove): void {
  store.handlePose.value = pose;
  next = pose;
  void pump();
}

async function pump(): Promise<void> {
  if (flying) return;
  flying = true;
  while (next) {
    const pose = next;
    next = null;
    noteHandleMove();
    const answer = await send({ do: 'handle_move', ...pose });
    if (!answer.ok) break;
  }
  flying = false;
}

/** Changes the soft radius; while a handle is held the engine answers with another preview. */
export function setSoftRadius(radius_mm: number): void {
  store.softRadius.value = radius_mm;
  if (store.handleCenter.peek()) void send({ do: 'handle_radius', radius_mm });
}

export function acceptHandle(): void {
  if (!store.handleCenter.peek()) return;
  next = null;
  void send({ do: 'handle_accept' });
}

/** Lets go. The selection stays. */
export function cancelHandle(): void {
  beginning++;
  next = null;
  store.handlePose.value = restPose;
  store.preview.value = null;
  store.handleCenter.value = null;
  void send({ do: 'handle_cancel' }, true);
}

/** Puts the pose back to rest, keeping hold. */
export function resetPose(): void {
  moveHandle(restPose);
}

/** Where the gizmo stands. */
export function gizmoPlace(): Vec3 | null {
  const center = store.handleCenter.value;
  const { move_mm } = store.handlePose.value;
  return center && [center[0] + move_mm[0], center[1] + move_mm[1], center[2] + move_mm[2]];
}
