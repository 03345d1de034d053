import { expect, test } from 'vitest';
import type { Warning } from '../../src/core/protocol';
import { changeBars, parameterText } from '../../src/panels/logic/changes';
import { documentName, fileStem } from '../../src/panels/logic/file_names';
import { holderOf, withKeys, withoutChoice } from '../../src/panels/logic/key_map';
import { ariaKeys, keyText } from '../../src/panels/logic/keys';
import { matches, score } from '../../src/panels/logic/match';
import { materialChoices } from '../../src/panels/logic/materials';
import { preflight, preflightSummary } from '../../src/panels/logic/preflight';
import { drawingPath, openable, titleOf } from '../../src/panels/logic/start_entries';
import { verdictLine } from '../../src/panels/logic/verdict_line';
import { listText, sentence } from '../../src/panels/logic/words';
import { plan, verdict } from './scene';

const known = { connection: 'open', running: true, dragging: false, moving: false, lookOnly: false } as const;

test('the verdict line is one true sentence', () => {
  const calm = verdictLine({ ...known, verdict: verdict() });
  expect(calm).toEqual({
    tone: 'calm',
    text: 'Settled in 62 ms, 2 iterations.',
    details: ['residual 3 × 10⁻⁷ N', 'stable (lowest mode 0.8 N/m)'],
  });
  expect(verdictLine({ ...known, verdict: verdict({ note: 'jumped to another shape' }) }).text).toContain('Jumped to another shape.');
  expect(verdictLine({ ...known, running: false, verdict: verdict() }).text).toContain('does not follow');
  expect(verdictLine({ ...known, verdict: verdict({ name: 'critical' }) }).tone).toBe('warn');
  const stalled = verdict({ name: 'stalled', settled: false, shown: 'last good', sentence: 'no step lowers the energy' });
  expect(verdictLine({ ...known, verdict: stalled })).toMatchObject({
    tone: 'bad',
    text: 'No step lowers the energy. The last good shape is shown.',
  });
  // What is on its way has not gone wrong.
  expect(verdictLine({ ...known, moving: true, verdict: verdict() }).tone).toBe('busy');
  expect(verdictLine({ ...known, connection: 'lost', verdict: verdict() }).tone).toBe('bad');
  expect(verdictLine({ ...known, lookOnly: true, verdict: null }).text).toContain('To look at');
  expect(verdictLine({ ...known, verdict: null }).text).toBe('No shape yet.');
});

test('the checklist turns green by itself', () => {
  const slack: Warning = {
    what: 'slack fabric',
    where: 'between rods 3 and 7',
    value: 1.012,
    unit: '',
    remedy: 'raise the stretch to 1.46',
    one_click: true,
    nodes: [1],
  };
  const good = { verdict: verdict(), warnings: [], measures: null, plan: plan(), saved: true };
  const ready = preflight(good);
  expect(ready.every((check) => check.state === 'ready')).toBe(true);
  expect(preflightSummary(ready)).toBe('Ready to be made.');
  expect(ready.find((check) => check.key === 'thin rod')?.text).toBe('The thinnest is 0.84\u00a0mm thick.');
  const odd = { ...slack, what: 'odd thing', where: 'rod 3' };
  const checks = preflight({ ...good, warnings: [odd, slack, slack], saved: false });
  expect(checks.find((check) => check.key === 'slack fabric')).toMatchObject({
    state: 'stop',
    text: 'between rods 3 and 7: 1.012. Raise the stretch to 1.46. And 1 more place.',
    warnings: [1, 2],
  });
  expect(checks.find((check) => check.title === 'Odd thing')).toMatchObject({ state: 'look', warnings: [0] });
  expect(preflightSummary(checks)).toBe('1 thing has to be put right first.');
  expect(preflight({ ...good, verdict: verdict({ settled: false }) })[0].state).toBe('stop');
});

test('the search finds by words and their beginnings, titles first', () => {
  const entries = ['Undo', 'Redo', 'Plan below the shape', 'Look for other stable shapes'];
  const find = (query: string) => matches(query, entries, (e) => e, () => 'plan');
  expect(find('und')[0]).toBe('Undo');
  expect(find('pl')[0]).toBe('Plan below the shape');
  expect(find('stable shapes')[0]).toBe('Look for other stable shapes');
  expect(find('')).toEqual(entries);
  expect(find('xyz')).toEqual([]);
  expect(score('mvp', 'Move point')).toBeGreaterThan(0);
});

test('a key belongs to one command', () => {
  const commands = [
    { id: 'a', title: 'A', keys: ['G'] },
    { id: 'b', title: 'B', keys: ['R', 'S'] },
  ];
  expect(holderOf('S', commands, 'a')?.id).toBe('b');
  expect(withKeys({}, commands, 'a', 'S')).toEqual({ a: ['S'], b: ['R'] });
  expect(withKeys({}, commands, 'a', 'X')).toEqual({ a: ['X'] });
  expect(withoutChoice({ a: ['S'], b: [] }, 'a')).toEqual({ b: [] });
  expect(keyText('Ctrl+Shift+Z', false)).toBe('Ctrl+Shift+Z');
  expect(keyText('Ctrl+Shift+Z', true)).toBe('⌘⇧Z');
  expect(keyText('Plus', false)).toBe('+');
  expect(ariaKeys([])).toBeUndefined();
  expect(ariaKeys(['Ctrl+K'])).toBe('Control+K');
});

test('words and names', () => {
  expect(sentence('raise the stretch')).toBe('Raise the stretch.');
  expect(sentence('Done!')).toBe('Done!');
  expect(listText(['a', 'b', 'c'])).toBe('a, b and c');
  expect(listText(['a', 'b', 'c', 'd', 'e'])).toBe('a, b, c and 2 more');
  expect(fileStem('wings/butterfly.lissom')).toBe('butterfly');
  expect(documentName(' wing ')).toBe('wing.lissom');
  expect(titleOf('disc-crossed')).toBe('Disc crossed');
  expect(materialChoices(['PLA'], 'oak').map((m) => m.value)).toEqual(['oak', 'PLA']);
});

test('files are listed with the recent ones first', () => {
  const file = (name: string, kind: 'plan' | 'other', modified: number) => ({ name, kind, bytes: 1, modified });
  const files = [file('old', 'plan', 1), file('new', 'plan', 2), file('note', 'other', 3), file('recent', 'plan', 0)];
  expect(openable(files, ['recent']).map((f) => f.name)).toEqual(['recent', 'new', 'old']);
});

test('changes are bars of comparable length', () => {
  const bars = changeBars([
    { parameter: 'r', unit: 'mm', from: 1, to: 2, at_bound: false },
    { parameter: 's', unit: '', from: 2, to: 1.5, at_bound: true },
  ]);
  expect(bars[0]).toMatchObject({ length: 1, text: '1 → 2\u00a0mm', atBound: false });
  expect(parameterText('point "rim-3": r_b')).toBe('rim-3: radius in plane');
  expect(parameterText('pre-stretch along warp')).toBe('Pre-stretch along warp');
  expect(bars[1].length).toBeCloseTo(-0.5);
  expect(drawingPath([[[0, 0], [10, 5]]]).path).toBe('M0.0 0.0L10.0 -5.0');
});
