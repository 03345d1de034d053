// Materials that the engine knows, whichever way it names them.

import type { Hello } from '../../core/protocol';
import { sentenceCase } from './words';

export interface MaterialChoice {
  value: string;
  title: string;
}

/** For a choice: those of the engine, and the present one where it is not among them. */
export function materialChoices(known: Hello['materials'] | undefined, present: string): MaterialChoice[] {
  const choices = (known ?? []).map((material) =>
    typeof material === 'string'
      ? { value: material, title: sentenceCase(material) }
      : { value: material.name, title: sentenceCase(material.title ?? material.name) },
  );
  if (present !== '' && !choices.some((choice) => choice.value === present)) {
    choices.unshift({ value: present, title: `${sentenceCase(present)} (of this file)` });
  }
  return choices;
}
