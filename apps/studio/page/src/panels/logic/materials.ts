// Materials that the engine knows, for a choice.

import { sentenceCase } from './words';

export interface MaterialChoice {
  value: string;
  title: string;
}

/** For a choice: those of the engine, and the present one where it is not among them. */
export function materialChoices(known: readonly string[] = [], present: string): MaterialChoice[] {
  const choices = known.map((name) => ({ value: name, title: sentenceCase(name) }));
  if (present !== '' && !choices.some((choice) => choice.value === present)) {
    choices.unshift({ value: present, title: `${sentenceCase(present)} (of this file)` });
  }
  return choices;
}
