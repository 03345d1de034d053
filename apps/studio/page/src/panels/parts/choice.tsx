// One of a few, with a label.

import { useId } from 'preact/hooks';

interface ChoiceProps<T extends string> {
  label: string;
  /** undefined: the things it stands for differ. */
  value: T | undefined;
  options: ReadonlyArray<{ value: T; title: string }>;
  disabled?: boolean;
  onChoose: (value: T) => void;
}

export function Choice<T extends string>({ label, value, options, disabled, onChoose }: ChoiceProps<T>) {
  const id = useId();
  return (
    <div class="pair">
      <label for={id}>{label}</label>
      <select
        id={id}
        class="choice"
        value={value ?? ''}
        disabled={disabled}
        onChange={(event) => onChoose(event.currentTarget.value as T)}
      >
        {value === undefined && (
          <option value="" disabled>
            mixed
          </option>
        )}
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {option.title}
          </option>
        ))}
      </select>
    </div>
  );
}

/** On or off. */
export function Switch(props: { label: string; checked: boolean; disabled?: boolean; help?: string; onSwitch: (on: boolean) => void }) {
  return (
    <label class="switch" title={props.help}>
      <input
        type="checkbox"
        checked={props.checked}
        disabled={props.disabled}
        onChange={(event) => props.onSwitch(event.currentTarget.checked)}
      />
      {props.label}
    </label>
  );
}
