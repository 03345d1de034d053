// Keys as the user wants them: who has a key, and what changes when it is given to another command.

export interface Keyed {
  id: string;
  title: string;
  keys: readonly string[];
}

/** The other command that has these keys. */
export function holderOf(keys: string, commands: readonly Keyed[], except: string): Keyed | undefined {
  return commands.find((command) => command.id !== except && command.keys.includes(keys));
}

/** The choices after `keys` went to `id`; whoever had them gives them up. */
export function withKeys(
  overrides: Readonly<Record<string, string[]>>,
  commands: readonly Keyed[],
  id: string,
  keys: string,
): Record<string, string[]> {
  const next: Record<string, string[]> = { ...overrides, [id]: [keys] };
  const holder = holderOf(keys, commands, id);
  if (holder) next[holder.id] = holder.keys.filter((other) => other !== keys);
  return next;
}

/** The choices without one. */
export function withoutChoice(overrides: Readonly<Record<string, string[]>>, id: string): Record<string, string[]> {
  return Object.fromEntries(Object.entries(overrides).filter(([key]) => key !== id));
}
