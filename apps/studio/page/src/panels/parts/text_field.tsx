// A line of text that counts when it is done: Enter or leaving takes it, Escape gives it back.

import { useEffect, useId, useRef, useState } from 'preact/hooks';
import type { Answer } from '../../core/protocol';
import { refusalText } from '../logic/words';
import { keepPlainKeys } from './field';

interface TextFieldProps {
  label: string;
  value: string;
  disabled?: boolean;
  onCommit: (value: string) => Promise<Answer | null>;
}

export function TextField({ label, value, disabled, onCommit }: TextFieldProps) {
  const id = useId();
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const [problem, setProblem] = useState('');
  const given = useRef(value);
  useEffect(() => {
    if (given.current !== value) setTyped(undefined);
    given.current = value;
  }, [value]);
  const accept = async () => {
    if (typed === undefined) return;
    if (typed.trim() === value) {
      setTyped(undefined);
      return;
    }
    const answer = await onCommit(typed.trim());
    const refusal = answer && !answer.ok ? answer.error : undefined;
    setProblem(refusal ? refusalText(refusal) : '');
    if (!refusal) setTyped(undefined);
  };
  return (
    <div class="pair">
      <label for={id}>{label}</label>
      <input
        id={id}
        class="entry"
        type="text"
        autocomplete="off"
        spellcheck={false}
        disabled={disabled}
        value={typed ?? value}
        aria-invalid={problem !== ''}
        aria-describedby={problem !== '' ? `${id}-problem` : undefined}
        onInput={(event) => setTyped(event.currentTarget.value)}
        onBlur={() => void accept()}
        onKeyDown={(event) => {
          keepPlainKeys(event);
          if (event.key === 'Enter') void accept();
          if (event.key !== 'Escape') return;
          setTyped(undefined);
          setProblem('');
        }}
      />
      {problem !== '' && (
        <p id={`${id}-problem`} class="field-problem" role="alert">
          {problem}
        </p>
      )}
    </div>
  );
}
