// The selected rods: curve, role, length, radii of their points, values of the shape along them.

import { useMemo } from 'preact/hooks';
import { makeSelection } from '../../core/selection';
import type { CurveKind, PlanEvent, PlanRod } from '../../core/protocol';
import { fabricField, lookOnly, plan, rodField, selection, settledShape, topology } from '../../core/store';
import { fieldEdit } from '../edits';
import { common } from '../logic/common';
import { valuesOfRod } from '../logic/edges';
import { counted, fixed, withUnit } from '../logic/number_text';
import { sentenceCase } from '../logic/words';
import { setFields } from '../../core/fields';
import { Button } from '../parts/button';
import { Choice, Switch } from '../parts/choice';
import { Facts } from '../parts/facts';
import { Section } from '../parts/section';
import { NameField } from './name_field';
import { RadiiFields } from './radii_fields';

const curves: ReadonlyArray<{ value: CurveKind; title: string }> = [
  { value: 'spline', title: 'Smooth curve' },
  { value: 'straight', title: 'Straight' },
  { value: 'arc', title: 'Arc' },
];

export function RodsSection() {
  const now = plan.value;
  const rods = now?.rods.filter((rod) => selection.value.rods.has(rod.name)) ?? [];
  if (!now || rods.length === 0) return null;
  const single = rods.length === 1 ? rods[0] : undefined;
  const names = rods.map((rod) => rod.name);
  const curve = common(rods.map((rod) => rod.curve));
  const points = [...new Set(rods.flatMap((rod) => rod.points))].map((p) => now.points[p]).filter((p) => p !== undefined);
  return (
    <Section title={single ? `Rod ${single.name}` : counted(rods.length, 'rod')}>
      {single && <NameField kind="rod" name={single.name} />}
      <Choice
        label="Curve"
        value={curve.kind === 'same' ? curve.value : undefined}
        options={curves}
        disabled={lookOnly.value}
        onChoose={(to) => void fieldEdit({ name: 'set_curve', rods: names, curve: to })}
      />
      <div class="row">
        <Switch
          label="Ghost"
          help="Drawn dashed, keeps its points, has no stiffness"
          checked={rods.every((rod) => rod.role === 'ghost')}
          disabled={lookOnly.value}
          onSwitch={(on) => void fieldEdit({ name: 'set_role', rods: names, role: on ? 'ghost' : 'rod' })}
        />
        {single && (
          <Switch
            label="Closed"
            help="Its end joins its beginning"
            checked={single.closed}
            disabled={lookOnly.value}
            onSwitch={(closed) => void fieldEdit({ name: 'set_closed', rod: single.name, closed })}
          />
        )}
      </div>
      <RadiiFields points={points} />
      <RodFacts rods={rods} />
      <RodActions plan={now} rods={rods} />
    </Section>
  );
}

/** Length in the plan, and the values of the settled shape along the rods. */
function RodFacts({ rods }: { rods: PlanRod[] }) {
  const mesh = topology.value;
  const shape = settledShape.value;
  const values = useMemo(() => {
    if (!mesh || !shape || rodField.value === '') return [];
    return rods.flatMap((rod) => valuesOfRod(mesh, rod.name, shape.edge_values));
  }, [mesh, shape, rods]);
  const facts: Array<readonly [string, string]> = [
    ['Length in the plan', withUnit(rods.reduce((sum, rod) => sum + rod.length_mm, 0), 'mm', 1)],
  ];
  if (shape && values.length > 0) {
    const unit = shape.field_rods.unit;
    const [low, high] = [Math.min(...values), Math.max(...values)];
    facts.push([sentenceCase(shape.field_rods.name), strainText(low, high, unit)]);
  }
  return (
    <>
      <Facts of={facts} />
      {rodField.value === '' && (
        <Button icon="eye" onClick={() => setFields('axial strain', fabricField.peek())}>
          Show strain
        </Button>
      )}
    </>
  );
}

function strainText(low: number, high: number, unit: string): string {
  if (unit !== '1' && unit !== '') return `${withUnit(low, unit)} to ${withUnit(high, unit)}`;
  return `${fixed(100 * low, 3)} to ${fixed(100 * high, 3)}\u00a0%`;
}

function RodActions({ plan: now, rods }: { plan: PlanEvent; rods: PlanRod[] }) {
  const names = rods.map((rod) => rod.name);
  const busy = lookOnly.value;
  const at_mm = now.constraints.symmetric?.at_mm ?? 0;
  const [cut] = [...selection.value.points].filter((name) => {
    const index = now.points.findIndex((point) => point.name === name);
    return rods.length === 1 && rods[0].points.slice(1, -1).includes(index);
  });
  return (
    <div class="row">
      <Button
        onClick={() => (selection.value = makeSelection({ points: rods.flatMap((rod) => rod.points.map((p) => now.points[p].name)) }))}
      >
        Select its points
      </Button>
      {cut !== undefined && (
        <Button icon="cut" disabled={busy} onClick={() => void fieldEdit({ name: 'split_rod', rod: names[0], point: cut })}>
          Split at {cut}
        </Button>
      )}
      {names.length === 2 && (
        <Button icon="merge" label="Join end to end" disabled={busy} onClick={() => void fieldEdit({ name: 'join_rods', rods: [names[0], names[1]] })}>
          Join
        </Button>
      )}
      {(['x', 'y'] as const).map((axis) => (
        <Button
          key={axis}
          icon="mirror"
          label={`Add mirror images across ${axis} = ${withUnit(at_mm, 'mm')}`}
          disabled={busy}
          onClick={() => void fieldEdit({ name: 'mirror', rods: names, axis, at_mm })}
        >
          Mirror {axis}
        </Button>
      ))}
      <Button icon="delete" disabled={busy} onClick={() => void fieldEdit({ name: 'remove', rods: names })}>
        Delete
      </Button>
    </div>
  );
}
