// What the view shows: values as colours, parts, overlays.

import { setFields } from '../../core/fields';
import type { NamedField } from '../../core/protocol';
import { fabricField, hello, orthographic, rodField, selectionFilter, show, type SelectionFilter } from '../../core/store';
import { Choice, Switch } from '../parts/choice';
import { Popover } from '../parts/popover';
import { sentenceCase } from '../logic/words';

const parts: ReadonlyArray<{ name: keyof typeof show; title: string }> = [
  { name: 'fabric', title: 'Fabric' },
  { name: 'rods', title: 'Rods' },
  { name: 'ghosts', title: 'Ghost rods' },
  { name: 'points', title: 'Control points' },
  { name: 'constraints', title: 'Pins and links' },
  { name: 'mesh', title: 'Mesh of the fabric' },
  { name: 'grid', title: 'Ground grid' },
];

const overlays: ReadonlyArray<{ name: keyof typeof show; title: string }> = [
  { name: 'flat', title: 'Flat plan' },
  { name: 'previous', title: 'Previous shape' },
  { name: 'target', title: 'Target' },
  { name: 'preview', title: 'Linear preview' },
];

export function ViewPopover() {
  return (
    <Popover role="dialog" label="What the view shows" icon="eye">
      {() => (
        <div class="stack">
          <FieldChoices />
          <Parts title="Parts" of={parts} />
          <Parts title="Overlays" of={overlays} />
          <Picks />
          <Switch label="Parallel projection" checked={orthographic.value} onSwitch={(on) => (orthographic.value = on)} />
        </div>
      )}
    </Popover>
  );
}

function FieldChoices() {
  const known = hello.value?.fields;
  const options = (fields: readonly NamedField[] | undefined) => [
    { value: '', title: 'Plain material' },
    ...(fields ?? []).map(({ name, unit }) => ({ value: name, title: unit === '' || unit === '1' ? sentenceCase(name) : `${sentenceCase(name)}, ${unit}` })),
  ];
  return (
    <>
      <Choice
        label="Colour of rods"
        value={rodField.value}
        options={options(known?.rods)}
        onChoose={(name) => setFields(name, fabricField.value)}
      />
      <Choice
        label="Colour of fabric"
        value={fabricField.value}
        options={options(known?.fabric)}
        onChoose={(name) => setFields(rodField.value, name)}
      />
    </>
  );
}

function Parts({ title, of }: { title: string; of: ReadonlyArray<{ name: keyof typeof show; title: string }> }) {
  return (
    <fieldset class="switches">
      <legend>{title}</legend>
      {of.map((part) => {
        const state = show[part.name];
        return <Switch key={part.name} label={part.title} checked={state.value} onSwitch={(on) => (state.value = on)} />;
      })}
    </fieldset>
  );
}

const picks: ReadonlyArray<{ name: keyof SelectionFilter; title: string }> = [
  { name: 'points', title: 'Control points' },
  { name: 'rods', title: 'Rods' },
  { name: 'nodes', title: 'Places of the mesh' },
];

function Picks() {
  const now = selectionFilter.value;
  return (
    <fieldset class="switches">
      <legend>A click picks</legend>
      {picks.map(({ name, title }) => (
        <Switch key={name} label={title} checked={now[name]} onSwitch={(on) => (selectionFilter.value = { ...now, [name]: on })} />
      ))}
    </fieldset>
  );
}
