// A number with its unit: entry, slider, reset, and the reason where it was refused. The entry takes "1.2 mm" and sums;
// arrow keys step (Shift: ten steps, Alt: a tenth). What is dragged or stepped through becomes one step of history.

import { useEffect, useId, useRef, useState } from 'preact/hooks';
import type { TargetedKeyboardEvent } from 'preact';
import { run } from '../../core/commands';
import type { Answer } from '../../core/protocol';
import { fixed, withUnit } from '../logic/number_text';
import { readQuantity } from '../logic/quantity';
import { refusalText } from '../logic/words';
import { Scrub } from '../logic/scrub';
import { Button } from './button';

/** Letters and arrows mean the entry, not the tools; Ctrl with a letter goes on to the commands. */
export function keepPlainKeys(event: KeyboardEvent): void {
  if (!event.ctrlKey && !event.metaKey) event.stopPropagation();
}

/** Ctrl+Z where nothing is being typed means the design, not the text. */
function historyKey(event: KeyboardEvent): boolean {
  if (!event.ctrlKey && !event.metaKey) return false;
  const key = event.key.toLowerCase();
  if (key === 'z') return run(event.shiftKey ? 'edit.redo' : 'edit.undo');
  return key === 'y' && run('edit.redo');
}

export interface FieldProps {
  label: string;
  /** '' for plain numbers. */
  unit: string;
  /** undefined: the things it stands for have different values. */
  value: number | undefined;
  digits: number;
  step: number;
  /** Ends of the slider; typed values may go beyond. No slider without them. */
  range?: readonly [number, number];
  /** What reset goes back to. */
  initial?: number;
  disabled?: boolean;
  /** The value as it would be now; absent: only whole changes count. */
  onPreview?: (value: number) => void;
  /** Answers with what the engine says, or null where nobody has to be asked. */
  onCommit: (value: number) => Promise<Answer | null> | null;
}

export function Field(props: FieldProps) {
  const { label, unit, value, digits, step, range, initial, disabled } = props;
  const id = useId();
  /** What is being typed; undefined: the value is shown. */
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const [moved, setMoved] = useState<number | undefined>(undefined);
  const [problem, setProblem] = useState('');
  const latest = useRef(props);
  latest.current = props;

  const commit = async (wanted: number): Promise<boolean> => {
    const answer = await latest.current.onCommit(wanted);
    setMoved(undefined);
    const refusal = answer && !answer.ok ? answer.error : undefined;
    setProblem(refusal ? refusalText(refusal) : '');
    return refusal === undefined;
  };
  const scrub = useRef<Scrub | undefined>(undefined);
  /** The slider is held by the pointer: resting there does not end the run. */
  const held = useRef(false);
  scrub.current ??= new Scrub(() => ({
    preview: (wanted) => {
      setMoved(wanted);
      latest.current.onPreview?.(wanted);
    },
    commit: (wanted) => void commit(wanted),
  }));
  // What was stepped through must not be lost with the panel.
  useEffect(() => () => scrub.current?.end(), []);

  const now = moved ?? value;
  const text = typed ?? (now === undefined ? '' : fixed(now, digits).replace('−', '-'));

  const accept = async () => {
    scrub.current?.end();
    if (typed === undefined) return;
    const reading = readQuantity(typed, unit);
    if ('problem' in reading) {
      setProblem(reading.problem);
      return;
    }
    if (value !== undefined && fixed(reading.value, digits + 3) === fixed(value, digits + 3)) {
      setTyped(undefined);
      setProblem('');
      return;
    }
    if (await commit(reading.value)) setTyped(undefined);
  };

  const pressed = (event: TargetedKeyboardEvent<HTMLInputElement>) => {
    keepPlainKeys(event);
    if (typed === undefined && historyKey(event)) {
      event.preventDefault();
      event.stopPropagation();
    } else if (event.key === 'Enter') {
      void accept();
      event.currentTarget.select();
    } else if (event.key === 'Escape') {
      setTyped(undefined);
      setProblem('');
    } else if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
      event.preventDefault();
      const size = step * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
      const from = scrub.current?.pending ?? now ?? range?.[0] ?? 0;
      setTyped(undefined);
      scrub.current?.step(Number((from + (event.key === 'ArrowUp' ? size : -size)).toFixed(digits + 2)));
    }
  };

  return (
    <div class="field">
      <label class="field-label" for={id}>
        {label}
      </label>
      {initial !== undefined && value !== initial && !disabled && (
        <Button
          icon="reset"
          class="field-reset"
          label={`Reset ${label.toLowerCase()} to ${withUnit(initial, unit, digits)}`}
          onClick={() => void commit(initial)}
        />
      )}
      <span class="field-entry">
        <input
          id={id}
          class="entry number"
          type="text"
          inputMode="decimal"
          autocomplete="off"
          role="spinbutton"
          aria-label={unit === '' ? label : `${label}, ${unit}`}
          aria-valuenow={now}
          aria-valuetext={now === undefined ? 'mixed' : withUnit(now, unit, digits)}
          aria-invalid={problem !== ''}
          aria-describedby={problem !== '' ? `${id}-problem` : undefined}
          placeholder={value === undefined ? 'mixed' : undefined}
          disabled={disabled}
          value={text}
          onFocus={(event) => event.currentTarget.select()}
          onInput={(event) => setTyped(event.currentTarget.value)}
          onBlur={() => void accept()}
          onKeyDown={pressed}
        />
        {unit !== '' && (
          <span class="field-unit" aria-hidden="true">
            {unit}
          </span>
        )}
      </span>
      {range && (
        <input
          class="slider"
          type="range"
          aria-label={`${label}${unit === '' ? '' : `, ${unit}`} (slider)`}
          aria-valuetext={now === undefined ? 'mixed' : withUnit(now, unit, digits)}
          min={range[0]}
          max={range[1]}
          step={step}
          disabled={disabled}
          value={now ?? range[0]}
          onKeyDown={keepPlainKeys}
          onPointerDown={() => (held.current = true)}
          onInput={(event) => {
            const wanted = event.currentTarget.valueAsNumber;
            if (held.current) scrub.current?.move(wanted);
            else scrub.current?.step(wanted);
          }}
          onChange={() => {
            if (held.current) scrub.current?.end();
            held.current = false;
          }}
          onBlur={() => scrub.current?.end()}
        />
      )}
      {problem !== '' && (
        <p id={`${id}-problem`} class="field-problem" role="alert">
          {problem}
        </p>
      )}
    </div>
  );
}
