// Finds what was meant by a few letters: for the command search.

/** How well a text answers a query; 0: not at all. Whole words and their beginnings count most. */
export function score(query: string, text: string): number {
  const wanted = query.trim().toLowerCase().split(/\s+/).filter((w) => w !== '');
  const line = text.toLowerCase();
  let sum = 1;
  for (const word of wanted) {
    const found = wordScore(word, line);
    if (found === 0) return 0;
    sum += found;
  }
  return sum - line.length / 1000;
}

function wordScore(word: string, line: string): number {
  if (line.startsWith(word)) return 10;
  const words = line.split(/[^\p{L}\p{N}]+/u);
  if (words.some((w) => w.startsWith(word))) return 7;
  if (line.includes(word)) return 4;
  return inOrder(word, line) ? 1 : 0;
}

/** Its letters occur in this order: "mvp" in "move point". */
function inOrder(word: string, line: string): boolean {
  if (word.length < 3) return false;
  let at = -1;
  for (const letter of word) {
    at = line.indexOf(letter, at + 1);
    if (at < 0) return false;
  }
  return true;
}

/** What the title says counts more than what else is known. */
function ratedBy(query: string, title: string, more: string): number {
  return 10 * score(query, title) + score(query, `${title} ${more}`);
}

/** The entries that answer, best first; all in their order for an empty query. */
export function matches<T>(query: string, entries: readonly T[], titleOf: (entry: T) => string, moreOf: (entry: T) => string): T[] {
  if (query.trim() === '') return [...entries];
  return entries
    .map((entry, order) => ({ entry, order, score: ratedBy(query, titleOf(entry), moreOf(entry)) }))
    .filter((found) => found.score > 0)
    .sort((a, b) => b.score - a.score || a.order - b.order)
    .map((found) => found.entry);
}
