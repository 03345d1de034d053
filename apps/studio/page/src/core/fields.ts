// Which values colour the shape, and the range of their colours.

import { send } from './connection';
import type { FieldInfo, ShapePack } from './protocol';
import { design, fabricField, fabricRange, rodField, rodRange, type LegendRange } from './store';
import type { Signal } from '@preact/signals-core';

/** Asks the engine for other values (for all pages); empty names: plain material. */
export function setFields(rods: string, fabric: string): void {
  rodField.value = rods;
  fabricField.value = fabric;
  void send({ do: 'fields', rods, fabric });
}

/** What the ranges were fitted to last. */
let fitted = '';

/** Unlocked ranges follow the values of a shape. */
export function fitRanges(shape: ShapePack): void {
  // While a solve runs colours hold still; other values and other designs get a range of their own at once.
  const of = `${design.peek()} ${shape.field_rods?.name} ${shape.field_fabric?.name}`;
  if (!shape.settled && of === fitted) return;
  fitted = of;
  follow(rodRange, shape.field_rods);
  follow(fabricRange, shape.field_fabric);
}

function follow(range: Signal<LegendRange>, field: FieldInfo | undefined): void {
  if (!field) return;
  const now = range.peek();
  if (now.locked) return;
  const [low, high] = hull(field);
  if (low !== now.low || high !== now.high) range.value = { low, high, locked: false };
}

/** Low and high of a field's colours: symmetric about 0 when it diverges, never empty. */
export function hull(field: FieldInfo): [number, number] {
  if (field.diverging) {
    const most = Math.max(Math.abs(field.low), Math.abs(field.high)) || 1;
    return [-most, most];
  }
  return field.high > field.low ? [field.low, field.high] : [field.low, field.low + 1];
}

/** Sets one end of a range and locks it. */
export function lockRange(range: Signal<LegendRange>, low: number, high: number): void {
  range.value = { low, high: high > low ? high : low + 1e-9, locked: true };
}
