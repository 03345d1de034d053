// Names of the engine as people say them.

/** "axial strain" as "Axial strain". */
export function sentenceCase(text: string): string {
  return text === '' ? text : text[0].toUpperCase() + text.slice(1);
}

/** What was refused, and what to do: full sentences. */
export function refusalText({ message, hint }: { message: string; hint: string }): string {
  return [message, hint].filter((part) => part !== '').map(sentence).join(' ');
}

/** A list in a sentence: "a, b and c"; longer ones are cut. */
export function listText(names: readonly string[], most = 4): string {
  if (names.length === 0) return '';
  if (names.length === 1) return names[0];
  if (names.length > most) return `${names.slice(0, most - 1).join(', ')} and ${names.length - most + 1} more`;
  return `${names.slice(0, -1).join(', ')} and ${names[names.length - 1]}`;
}

/** Ends in a full stop, begins with a capital. */
export function sentence(text: string): string {
  const trimmed = sentenceCase(text.trim());
  return trimmed === '' || /[.!?]$/.test(trimmed) ? trimmed : `${trimmed}.`;
}
