// What has to stay as it is: pins, attachments, planes, symmetry. Points come from the selection.

import { makeSelection } from '../../core/selection';
import type { Constraints } from '../../core/protocol';
import { lookOnly, plan, selection } from '../../core/store';
import { setConstraints } from '../edits';
import { listText } from '../logic/words';
import { Button } from '../parts/button';
import { Choice } from '../parts/choice';
import { Field } from '../parts/field';
import { Section } from '../parts/section';

interface Kept {
  key: string;
  text: string;
  points: readonly string[];
  without: (now: Constraints) => Partial<Constraints>;
}

export function ConstraintsSection({ open = true }: { open?: boolean }) {
  const now = plan.value?.constraints;
  if (!now) return null;
  const kept = keptOf(now);
  return (
    <Section title="Constraints" aside={kept.length === 0 ? 'none' : String(kept.length)} open={open}>
      <ul aria-label="Constraints">
        {kept.map((one) => (
          <li key={one.key} class="row between">
            <button type="button" class="place-row" onClick={() => (selection.value = makeSelection({ points: one.points }))}>
              {one.text}
            </button>
            <Button
              icon="close"
              label={`Let go: ${one.text.toLowerCase()}`}
              disabled={lookOnly.value}
              onClick={() => setConstraints(one.without)}
            />
          </li>
        ))}
      </ul>
      <AddFromSelection />
      <SymmetryFields now={now} />
    </Section>
  );
}

function keptOf(now: Constraints): Kept[] {
  return [
    ...now.pinned.map((name) => ({
      key: `pin ${name}`,
      text: `Pinned: ${name}`,
      points: [name],
      without: (c: Constraints) => ({ pinned: c.pinned.filter((other) => other !== name) }),
    })),
    ...now.attached.map(([a, b], k) => ({
      key: `link ${a} ${b}`,
      text: `Attached: ${a} and ${b}`,
      points: [a, b],
      without: (c: Constraints) => ({ attached: c.attached.filter((_, other) => other !== k) }),
    })),
    ...now.in_plane.map((names, k) => ({
      key: `plane ${names.join(' ')}`,
      text: `In a plane: ${listText(names)}`,
      points: names,
      without: (c: Constraints) => ({ in_plane: c.in_plane.filter((_, other) => other !== k) }),
    })),
  ];
}

function AddFromSelection() {
  const names = [...selection.value.points];
  if (names.length === 0) return <p class="small soft">Select points to pin them, attach two, or keep three or more in a plane.</p>;
  return (
    <div class="row">
      <Button
        icon="pin"
        disabled={lookOnly.value}
        onClick={() => setConstraints((now) => ({ pinned: [...new Set([...now.pinned, ...names])] }))}
      >
        Pin {names.length === 1 ? names[0] : `${names.length} points`}
      </Button>
      {names.length === 2 && (
        <Button
          icon="link"
          label="Keep their distance as it is"
          disabled={lookOnly.value}
          onClick={() => setConstraints((now) => ({ attached: [...now.attached, [names[0], names[1]]] }))}
        >
          Attach
        </Button>
      )}
      {names.length >= 3 && (
        <Button
          icon="plan"
          disabled={lookOnly.value}
          onClick={() => setConstraints((now) => ({ in_plane: [...now.in_plane, names] }))}
        >
          Keep in a plane
        </Button>
      )}
    </div>
  );
}

function SymmetryFields({ now }: { now: Constraints }) {
  const symmetric = now.symmetric;
  const set = (axis: 'none' | 'x' | 'y', at_mm: number) =>
    setConstraints(() => ({ symmetric: axis === 'none' ? null : { axis, at_mm } }));
  return (
    <>
      <Choice
        label="Mirror symmetry"
        value={symmetric?.axis ?? 'none'}
        options={[
          { value: 'none', title: 'None' },
          { value: 'x', title: 'Left and right (x)' },
          { value: 'y', title: 'Front and back (y)' },
        ]}
        disabled={lookOnly.value}
        onChoose={(axis) => set(axis, symmetric?.at_mm ?? 0)}
      />
      {symmetric && (
        <>
          <Field
            label={`Mirror line, ${symmetric.axis}`}
            unit="mm"
            digits={2}
            step={1}
            value={symmetric.at_mm}
            disabled={lookOnly.value}
            onCommit={(at_mm) => {
              set(symmetric.axis, at_mm);
              return null;
            }}
          />
          <p class="small soft">What is done on one side is done on the other.</p>
        </>
      )}
    </>
  );
}
