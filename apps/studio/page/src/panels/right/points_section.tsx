// The selected points: places, radii, kink, what they belong to.

import { makeSelection } from '../../core/selection';
import type { PlanEvent, PlanPoint } from '../../core/protocol';
import { lookOnly, plan, selection } from '../../core/store';
import { fieldEdit, setConstraints, useDragged } from '../edits';
import { common } from '../logic/common';
import { counted } from '../logic/number_text';
import { Button } from '../parts/button';
import { Switch } from '../parts/choice';
import { Field } from '../parts/field';
import { Section } from '../parts/section';
import { NameField } from './name_field';
import { RadiiFields } from './radii_fields';

export function PointsSection() {
  const now = plan.value;
  if (!now) return null;
  const points = now.points.filter((point) => selection.value.points.has(point.name));
  if (points.length === 0) return null;
  const single = points.length === 1 ? points[0] : undefined;
  return (
    <Section title={single ? `Point ${single.name}` : counted(points.length, 'point')}>
      {single && <NameField kind="point" name={single.name} />}
      <PlaceField axis={0} points={points} />
      <PlaceField axis={1} points={points} />
      <RadiiFields points={points} />
      <PointSwitches points={points} />
      {single && <RodsThrough plan={now} point={single} />}
      <PointActions points={points} />
    </Section>
  );
}

function PlaceField({ axis, points }: { axis: 0 | 1; points: PlanPoint[] }) {
  const shared = common(points.map((point) => point.at_mm[axis]), 1e-6);
  const drag = useDragged((value) => ({
    name: 'move_points',
    moves: points.map(({ name, at_mm }) => ({ point: name, to_mm: axis === 0 ? [value, at_mm[1]] : [at_mm[0], value] })),
  }));
  return (
    <Field
      label={axis === 0 ? 'x' : 'y'}
      unit="mm"
      digits={2}
      step={0.5}
      value={shared.kind === 'same' ? shared.value : undefined}
      disabled={lookOnly.value}
      {...drag}
    />
  );
}

function PointSwitches({ points }: { points: PlanPoint[] }) {
  const names = points.map((point) => point.name);
  const pinned = plan.value?.constraints.pinned ?? [];
  const allPinned = names.every((name) => pinned.includes(name));
  return (
    <div class="row">
      <Switch
        label="Pinned"
        help="Stays where it is while modes and handles move the shape"
        checked={allPinned}
        disabled={lookOnly.value}
        onSwitch={(on) =>
          setConstraints((now) => ({
            pinned: on ? [...new Set([...now.pinned, ...names])] : now.pinned.filter((name) => !names.includes(name)),
          }))
        }
      />
      <Switch
        label="Kink"
        help="Rods are cut here and may kink"
        checked={points.every((point) => point.split)}
        disabled={lookOnly.value}
        onSwitch={(split) => void fieldEdit({ name: 'set_split', points: names, split })}
      />
    </div>
  );
}

function RodsThrough({ plan: now, point }: { plan: PlanEvent; point: PlanPoint }) {
  const index = now.points.indexOf(point);
  const rods = now.rods.filter((rod) => rod.points.includes(index));
  if (rods.length === 0) return null;
  return (
    <div class="row">
      <span class="soft">Rods here</span>
      {rods.map((rod) => (
        <Button key={rod.name} onClick={() => (selection.value = makeSelection({ rods: [rod.name] }))}>
          {rod.name}
        </Button>
      ))}
    </div>
  );
}

function PointActions({ points }: { points: PlanPoint[] }) {
  const names = points.map((point) => point.name);
  const busy = lookOnly.value;
  return (
    <div class="row">
      {names.length === 2 && (
        <Button
          icon="link"
          label="Keep their distance as it is"
          disabled={busy}
          onClick={() => setConstraints((now) => ({ attached: [...now.attached, [names[0], names[1]]] }))}
        >
          Attach
        </Button>
      )}
      {names.length >= 3 && (
        <Button
          icon="plan"
          label="Keep them in one plane"
          disabled={busy}
          onClick={() => setConstraints((now) => ({ in_plane: [...now.in_plane, names] }))}
        >
          Keep in a plane
        </Button>
      )}
      {names.length >= 2 && (
        <Button icon="merge" label="Make them one point" disabled={busy} onClick={() => void fieldEdit({ name: 'merge_points', points: names })}>
          Merge
        </Button>
      )}
      <Button icon="delete" disabled={busy} onClick={() => void fieldEdit({ name: 'remove', points: names })}>
        Delete
      </Button>
    </div>
  );
}
