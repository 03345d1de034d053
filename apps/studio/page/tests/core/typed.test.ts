import { beforeEach, describe, expect, test } from 'vitest';
import { restPose } from '../../src/core/gizmo';
import * as store from '../../src/core/store';
import { typed } from '../../src/view/local';
import { endTyping, shapeKey, typedPose } from '../../src/view/shape_keys';

const press = (key: string) => shapeKey({ key, ctrlKey: false, metaKey: false, altKey: false } as KeyboardEvent);

describe('typed numbers for the handle', () => {
  beforeEach(() => {
    endTyping();
    store.gizmoKind.value = 'move';
    store.handlePose.value = restPose;
  });

  test('mean what they say, in their unit', () => {
    expect(typedPose('12.5', restPose, 'move', 0)?.move_mm).toEqual([12.5, 0, 0]);
    expect(typedPose('1 cm', restPose, 'move', 1)?.move_mm).toEqual([0, 10, 0]);
    expect(typedPose('45', restPose, 'rotate', -1)?.turn_deg).toEqual([0, 0, 45]);
    expect(typedPose('1.2', restPose, 'scale', -1)?.scale).toBeCloseTo(1.2);
    expect(typedPose('0', restPose, 'scale', -1)).toBeNull();
    expect(typedPose('1.', restPose, 'rotate', 2)?.turn_deg[2]).toBe(1);
    expect(typedPose('abc', restPose, 'move', 2)).toBeNull();
  });

  test('begin with a letter: digits alone are views', () => {
    expect(press('7')).toBe(false);
    expect(press('g')).toBe(true);
    expect(press('x')).toBe(true);
    for (const key of '-3.5') expect(press(key)).toBe(true);
    expect(store.handlePose.value.move_mm).toEqual([-3.5, 0, 0]);
    expect(typed.value).toContain('move x');
    press('Backspace');
    press('Backspace');
    expect(store.handlePose.value.move_mm).toEqual([-3, 0, 0]);
    endTyping();
    expect(typed.value).toBe('');
  });

  test('R and S turn and scale', () => {
    press('r');
    press('y');
    press('9');
    expect(store.handlePose.value.turn_deg).toEqual([0, 9, 0]);
    press('s');
    press('2');
    expect(store.handlePose.value.scale).toBe(2);
    expect(shapeKey({ key: 's', ctrlKey: true } as KeyboardEvent)).toBe(false);
    expect(press('q')).toBe(false);
  });
});
