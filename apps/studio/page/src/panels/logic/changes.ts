// What a handle would change, as bars of comparable length.

import type { PreviewPack } from '../../core/protocol';
import { withUnit } from './number_text';

export interface ChangeBar {
  parameter: string;
  /** "1.30 → 1.52 mm" */
  text: string;
  /** -1 to 1, of the largest relative change. */
  length: number;
  atBound: boolean;
}

export function changeBars(changes: PreviewPack['changes']): ChangeBar[] {
  const relative = changes.map(({ from, to }) => (to - from) / Math.max(Math.abs(from), Math.abs(to), 1e-9));
  const most = Math.max(...relative.map(Math.abs), 1e-9);
  return changes.map(({ parameter, unit, from, to, at_bound }, k) => ({
    parameter,
    text: `${withUnit(from, '')} → ${withUnit(to, unit)}`,
    length: relative[k] / most,
    atBound: at_bound,
  }));
}
