// The name of a point or rod; what is renamed stays selected.

import { makeSelection } from '../../core/selection';
import { lookOnly, selection } from '../../core/store';
import { fieldEdit } from '../edits';
import { TextField } from '../parts/text_field';

export function NameField({ kind, name }: { kind: 'point' | 'rod'; name: string }) {
  return (
    <TextField
      label="Name"
      value={name}
      disabled={lookOnly.value}
      onCommit={async (to) => {
        const answer = await fieldEdit(kind === 'point' ? { name: 'rename', point: name, to } : { name: 'rename', rod: name, to });
        if (answer.ok) selection.value = makeSelection(kind === 'point' ? { points: [to] } : { rods: [to] });
        return answer;
      }}
    />
  );
}
