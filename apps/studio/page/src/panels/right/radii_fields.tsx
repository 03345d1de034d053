// Radii of points: each of its own, or one value for all that are selected.

import type { PlanPoint } from '../../core/protocol';
import { lookOnly } from '../../core/store';
import { fieldEdit, useDragged } from '../edits';
import { common } from '../logic/common';
import { Field } from '../parts/field';

const kThinnest = 0.25;
const kThickest = 3;

export function RadiiFields({ points }: { points: readonly PlanPoint[] }) {
  const names = points.map((point) => point.name);
  const inPlane = common(points.map((point) => point.r_b_mm));
  const outOfPlane = common(points.map((point) => point.r_n_mm));
  const dragB = useDragged((r_b_mm) => ({ name: 'set_radii', points: names, r_b_mm }));
  const dragN = useDragged((r_n_mm) => ({ name: 'set_radii', points: names, r_n_mm }));
  return (
    <>
      <Field
        label="Radius in plane"
        unit="mm"
        digits={2}
        step={0.05}
        range={[kThinnest, kThickest]}
        value={inPlane.kind === 'same' ? inPlane.value : undefined}
        disabled={lookOnly.value}
        {...dragB}
      />
      <Field
        label="Radius out of plane"
        unit="mm"
        digits={2}
        step={0.05}
        range={[kThinnest, kThickest]}
        value={outOfPlane.kind === 'same' ? outOfPlane.value : undefined}
        disabled={lookOnly.value}
        {...dragN}
      />
      {points.length > 1 && (
        <Field
          label="Scale radii to"
          unit="%"
          digits={0}
          step={5}
          value={100}
          disabled={lookOnly.value}
          onCommit={(percent) => fieldEdit({ name: 'set_radii', points: names, factor: percent / 100 })}
        />
      )}
    </>
  );
}
