// What a handle would change, as bars of comparable length.

import type { PreviewPack } from '../../core/protocol';
import { withUnit } from './number_text';
import { sentenceCase } from './words';

export interface ChangeBar {
  parameter: string;
  /** "1.30 → 1.52 mm" */
  text: string;
  /** -1 to 1, of the largest relative change. */
  length: number;
  atBound: boolean;
}

const quantities: Readonly<Record<string, string>> = {
  x: 'x',
  y: 'y',
  r_n: 'radius out of plane',
  r_b: 'radius in plane',
};

/** A parameter as the inspector calls it: `point "a": r_b` is "a: radius in plane". */
export function parameterText(name: string): string {
  const match = /^point "(.+)": (\w+)$/.exec(name);
  if (!match) return sentenceCase(name);
  return `${match[1]}: ${quantities[match[2]] ?? match[2]}`;
}

export function changeBars(changes: PreviewPack['changes']): ChangeBar[] {
  const relative = changes.map(({ from, to }) => (to - from) / Math.max(Math.abs(from), Math.abs(to), 1e-9));
  const most = Math.max(...relative.map(Math.abs), 1e-9);
  return changes.map(({ parameter, unit, from, to, at_bound }, k) => ({
    parameter: parameterText(parameter),
    text: `${withUnit(from, '')} → ${withUnit(to, unit)}`,
    length: relative[k] / most,
    atBound: at_bound,
  }));
}
