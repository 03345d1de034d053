// What has to be right before it is made, from the verdict and the warnings: a list that turns green by itself.

import type { MeasuresEvent, PlanEvent, VerdictEvent, Warning } from '../../core/protocol';
import { counted, fixed, withUnit } from './number_text';
import { sentence, sentenceCase } from './words';

export interface Check {
  key: string;
  title: string;
  /** "look": can be made, but somebody should look at it. */
  state: 'ready' | 'look' | 'stop';
  /** One sentence. */
  text: string;
  /** Numbers in the list of warnings: places and remedies. */
  warnings: number[];
}

export interface Facts {
  verdict: VerdictEvent | null;
  warnings: readonly Warning[];
  measures: MeasuresEvent | null;
  plan: PlanEvent | null;
  saved: boolean;
}

interface Kind {
  what: string;
  title: string;
  good: (facts: Facts) => string;
  state: 'look' | 'stop';
}

const kinds: readonly Kind[] = [
  {
    what: 'slack fabric',
    title: 'The fabric is taut',
    good: ({ measures }) => (measures ? `Smallest stretch ${fixed(measures.smallest_stretch, 3)}.` : 'Taut everywhere.'),
    state: 'stop',
  },
  { what: 'thin rod', title: 'Rods can be printed', good: thinnest, state: 'stop' },
  { what: 'compressed rod', title: 'No rod is squeezed', good: () => 'No rod carries too much pressure.', state: 'look' },
  { what: 'turning angle', title: 'Bends are smooth enough', good: () => 'Edges are short enough for the bends.', state: 'look' },
];

export function preflight(facts: Facts): Check[] {
  const listed = facts.warnings.map((warning, index) => ({ warning, index }));
  const checks: Check[] = [standing(facts.verdict)];
  for (const kind of kinds) {
    const found = listed.filter(({ warning }) => warning.what === kind.what);
    checks.push({
      key: kind.what,
      title: kind.title,
      state: found.length === 0 ? 'ready' : kind.state,
      text: found.length === 0 ? kind.good(facts) : summary(found.map(({ warning }) => warning)),
      warnings: found.map(({ index }) => index),
    });
  }
  const known = new Set(kinds.map((kind) => kind.what));
  for (const { warning, index } of listed) {
    if (known.has(warning.what)) continue;
    checks.push({
      key: `${warning.what} ${index}`,
      title: sentenceCase(warning.what),
      state: 'look',
      text: summary([warning]),
      warnings: [index],
    });
  }
  checks.push(saved(facts.saved));
  return checks;
}

/** "3 of 6 are ready" and the like. */
export function preflightSummary(checks: readonly Check[]): string {
  const stops = checks.filter((check) => check.state === 'stop').length;
  const looks = checks.filter((check) => check.state === 'look').length;
  if (stops > 0) return `${counted(stops, 'thing has', 'things have')} to be put right first.`;
  if (looks > 0) return `Ready, but ${counted(looks, 'thing is', 'things are')} worth a look.`;
  return 'Ready to be made.';
}

function standing(verdict: VerdictEvent | null): Check {
  const base = { key: 'standing', title: 'The shape stands', warnings: [] };
  if (!verdict) return { ...base, state: 'stop', text: 'There is no shape yet.' };
  if (!verdict.settled) return { ...base, state: 'stop', text: sentence(verdict.sentence) };
  if (verdict.name !== 'stable') return { ...base, state: 'look', text: sentence(verdict.sentence) };
  return { ...base, state: 'ready', text: 'Settled and stable.' };
}

function saved(isSaved: boolean): Check {
  return {
    key: 'saved',
    title: 'The design is saved',
    state: isSaved ? 'ready' : 'look',
    text: isSaved ? 'File and screen agree.' : 'Files are written from what you see; the design itself is not saved yet.',
    warnings: [],
  };
}

function summary(warnings: readonly Warning[]): string {
  const [first] = warnings;
  const rest = warnings.length > 1 ? ` And ${counted(warnings.length - 1, 'more place', 'more places')}.` : '';
  const value = first.unit === '' ? fixed(first.value, 3) : withUnit(first.value, first.unit);
  return `${first.where}: ${value}. ${sentence(first.remedy)}${rest}`;
}

function thinnest({ plan }: Facts): string {
  const used = new Set(plan?.rods.filter((rod) => rod.role === 'rod').flatMap((rod) => rod.points));
  const radii = plan?.points.filter((_, k) => used.has(k)).flatMap((point) => [point.r_n_mm, point.r_b_mm]) ?? [];
  if (radii.length === 0) return 'Thick enough everywhere.';
  return `The thinnest is ${withUnit(2 * Math.min(...radii), 'mm', 2)} thick.`;
}
