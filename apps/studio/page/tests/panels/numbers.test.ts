import { expect, test } from 'vitest';
import { common } from '../../src/panels/logic/common';
import { agoText, bytesText, counted, durationText, fixed, short, whenText, withUnit } from '../../src/panels/logic/number_text';
import { readQuantity } from '../../src/panels/logic/quantity';
import { histogram, tickDigits, ticks } from '../../src/panels/logic/ticks';

function value(text: string, unit: string): number {
  const reading = readQuantity(text, unit);
  if ('problem' in reading) throw new Error(reading.problem);
  return reading.value;
}

function problem(text: string, unit: string): string {
  const reading = readQuantity(text, unit);
  return 'problem' in reading ? reading.problem : '';
}

test('reads numbers, units and sums', () => {
  expect(value('1.2', 'mm')).toBe(1.2);
  expect(value(' 1,2 mm ', 'mm')).toBeCloseTo(1.2);
  expect(value('3 cm + 4', 'mm')).toBeCloseTo(34);
  expect(value('2 * (1.2 + 0.3) mm', 'mm')).toBeCloseTo(3);
  expect(value('-(3 - 5)', 'mm')).toBe(2);
  expect(value('1e-1 m', 'mm')).toBeCloseTo(100);
  expect(value('1 in / 2', 'mm')).toBeCloseTo(12.7);
  expect(value('3.3 GPa', 'MPa')).toBeCloseTo(3300);
  expect(value('0.5 rad', '°')).toBeCloseTo(28.6479, 3);
  expect(value('110 %', '')).toBeCloseTo(1.1);
  expect(value('110 %', '%')).toBeCloseTo(110);
  expect(value('8 - 2 - 1', '')).toBe(5);
  expect(value('8 / 2 / 2', '')).toBe(2);
  expect(value('.5', 'mm')).toBe(0.5);
});

test('says what is wrong with a text', () => {
  expect(problem('', 'mm')).toBe('Type a number of mm.');
  expect(problem('wide', 'mm')).toContain('"wide" is not a number');
  expect(problem('3 kN', 'mm')).toBe('This is in mm, not in kN.');
  expect(problem('3 mm', '')).toBe('This is a plain number, not mm.');
  expect(problem('3 +', 'mm')).toBe('A number is missing at the end.');
  expect(problem('(3', 'mm')).toBe('A closing bracket is missing.');
  expect(problem('3 mm * 2 mm', 'mm')).toContain('Only one of the two');
  expect(problem('(3 mm) cm', 'mm')).toContain('There is a unit before cm already');
  expect(problem('1 / 0', 'mm')).toContain('has no value');
});

test('writes numbers for people', () => {
  expect(fixed(-0.001, 2)).toBe('0.00');
  expect(fixed(-1.5, 1)).toBe('−1.5');
  expect(fixed(Number.NaN, 1)).toBe('–');
  expect(short(3e-7, 2)).toBe('3 × 10⁻⁷');
  expect(short(0.8)).toBe('0.8');
  expect(short(12345)).toBe('12345');
  expect(short(1.23456)).toBe('1.23');
  expect(withUnit(1.3, 'mm', 2)).toBe('1.30\u00a0mm');
  expect(withUnit(20, '°', 0)).toBe('20°');
  expect(counted(1, 'warning')).toBe('1 warning');
  expect(counted(2, 'warning')).toBe('2 warnings');
  expect(durationText(62.4)).toBe('62 ms');
  expect(durationText(2442)).toBe('2.4 s');
  expect(bytesText(999)).toBe('999 B');
  expect(bytesText(12300)).toBe('12 kB');
  expect(agoText(3)).toBe('just now');
  expect(agoText(300)).toBe('5 minutes ago');
  expect(whenText(1000, 1000 + 400 * 86400)).toMatch(/^1970-01-01$/);
});

test('marks scales at round numbers', () => {
  expect(ticks(0, 1, 5)).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
  expect(ticks(-0.05, 0.05, 4)).toEqual([-0.05, -0.025, 0, 0.025, 0.05]);
  expect(ticks(2, 2)).toEqual([2]);
  expect(tickDigits([1.1, 1.2])).toBe(1);
  expect(ticks(-0.048, 0.048, 4)).toEqual([-0.025, 0, 0.025]);
  expect(tickDigits([-0.025, 0, 0.025])).toBe(3);
  expect(tickDigits([100, 200])).toBe(0);
  expect(histogram([0, 0.1, 0.9, 5, -3, Number.NaN], 0, 1, 2)).toEqual([3, 2]);
});

test('finds what things have in common', () => {
  expect(common([])).toEqual({ kind: 'none' });
  expect(common([1.3, 1.3])).toEqual({ kind: 'same', value: 1.3 });
  expect(common([1.3, 1.4])).toEqual({ kind: 'mixed' });
  expect(common(['arc', 'arc'])).toEqual({ kind: 'same', value: 'arc' });
});
