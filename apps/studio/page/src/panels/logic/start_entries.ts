// What the start page offers, from what the engine lists.

import type { FileEntry } from '../../core/protocol';

/** A drawing of rods: the lines of a plan, mm, y up. */
export type Drawing = ReadonlyArray<ReadonlyArray<readonly [number, number]>>;

/** "disc-crossed" as "Disc crossed". */
export function titleOf(name: string): string {
  const words = name.replace(/[-_]+/g, ' ');
  return words === '' ? words : words[0].toUpperCase() + words.slice(1);
}

/** What a file can be opened as, in a word; files that cannot be opened have none. */
export function kindText(kind: FileEntry['kind']): string | undefined {
  const kinds: Readonly<Partial<Record<FileEntry['kind'], string>>> = { plan: 'plan', project: 'plan', structure: 'to look at' };
  return kinds[kind];
}

/** Files that can be opened: recent ones first, then the newest. */
export function openable(files: readonly FileEntry[], recent: readonly string[]): FileEntry[] {
  const rank = (file: FileEntry) => {
    const at = recent.indexOf(file.name);
    return at < 0 ? recent.length : at;
  };
  return files
    .filter((file) => kindText(file.kind) !== undefined)
    .sort((a, b) => rank(a) - rank(b) || Number(b.modified) - Number(a.modified) || a.name.localeCompare(b.name));
}

/** The lines as one path with y down, and the box around them. */
export function drawingPath(lines: Drawing): { path: string; viewBox: string } {
  const all = lines.flat();
  if (all.length === 0) return { path: '', viewBox: '0 0 1 1' };
  const xs = all.map(([x]) => x);
  const ys = all.map(([, y]) => -y);
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const [wide, tall] = [Math.max(...xs) - left, Math.max(...ys) - top];
  const margin = 0.05 * Math.max(wide, tall, 1);
  const path = lines
    .map((line) => line.map(([x, y], k) => `${k === 0 ? 'M' : 'L'}${x.toFixed(1)} ${(-y).toFixed(1)}`).join(''))
    .join('');
  const box = [left - margin, top - margin, wide + 2 * margin, tall + 2 * margin];
  return { path, viewBox: box.map((v) => v.toFixed(1)).join(' ') };
}
