// The fabric: how far it is stretched before the rods come on, its direction, its mesh, its holes.

import { useSignal } from '@preact/signals';
import type { FabricSettings } from '../../core/protocol';
import { hello, lookOnly, plan } from '../../core/store';
import { fieldEdit, useDragged } from '../edits';
import { materialChoices } from '../logic/materials';
import { fixed } from '../logic/number_text';
import { Button } from '../parts/button';
import { Choice, Switch } from '../parts/choice';
import { Field } from '../parts/field';
import { Section } from '../parts/section';

const kStretch: readonly [number, number] = [1, 1.8];

export function FabricSection() {
  const fabric = plan.value?.fabric;
  if (!fabric) return null;
  return (
    <Section title="Fabric">
      <Stretch fabric={fabric} />
      <Choice
        label="Material"
        value={fabric.material}
        options={materialChoices(hello.value?.materials.fabric, fabric.material)}
        disabled={lookOnly.value}
        onChoose={(material) => void fieldEdit({ name: 'set_fabric', material })}
      />
      <WarpField fabric={fabric} />
      <Field
        label="Edge length"
        unit="mm"
        digits={2}
        step={0.5}
        value={fabric.edge_length_mm}
        disabled={lookOnly.value}
        onCommit={(edge_length_mm) => fieldEdit({ name: 'set_fabric', edge_length_mm })}
      />
      {fabric.edge_length_mm === 0 && <p class="small soft">0 mm: edges as long as those of the rods.</p>}
      <Field
        label="Smallest angle"
        unit="°"
        digits={1}
        step={1}
        value={fabric.min_angle_deg}
        disabled={lookOnly.value}
        onCommit={(min_angle_deg) => fieldEdit({ name: 'set_fabric', min_angle_deg })}
      />
      <Field
        label="Bending stiffness"
        unit="%"
        digits={0}
        step={10}
        initial={100}
        value={100 * fabric.bending}
        disabled={lookOnly.value}
        onCommit={(percent) => fieldEdit({ name: 'set_fabric', bending: percent / 100 })}
      />
      <Holes fabric={fabric} />
    </Section>
  );
}

function Stretch({ fabric }: { fabric: FabricSettings }) {
  const [warp, weft] = fabric.pre_stretch;
  const apart = useSignal(warp !== weft);
  const both = useDragged((value) => ({ name: 'set_pre_stretch', along: [value, value] }));
  const first = useDragged((value) => ({ name: 'set_pre_stretch', along: [value, weft] }));
  const second = useDragged((value) => ({ name: 'set_pre_stretch', along: [warp, value] }));
  const separate = apart.value || warp !== weft;
  const common = { unit: '', digits: 2, step: 0.01, range: kStretch, disabled: lookOnly.value } as const;
  return (
    <>
      <Field label={separate ? 'Stretch along warp' : 'Pre-stretch'} value={warp} {...common} {...(separate ? first : both)} />
      {separate && <Field label="Stretch along weft" value={weft} {...common} {...second} />}
      <Switch
        label="Different along warp and weft"
        checked={separate}
        disabled={lookOnly.value}
        onSwitch={(on) => {
          apart.value = on;
          if (!on && warp !== weft) void fieldEdit({ name: 'set_pre_stretch', along: [warp, warp] });
        }}
      />
    </>
  );
}

function WarpField({ fabric }: { fabric: FabricSettings }) {
  const drag = useDragged((warp_angle_deg) => ({ name: 'set_fabric', warp_angle_deg }));
  return (
    <Field
      label="Warp direction"
      unit="°"
      digits={1}
      step={5}
      range={[-90, 90]}
      initial={0}
      value={fabric.warp_angle_deg}
      disabled={lookOnly.value}
      {...drag}
    />
  );
}

function Holes({ fabric }: { fabric: FabricSettings }) {
  if (fabric.holes_mm.length === 0) return null;
  return (
    <ul aria-label="Holes">
      {fabric.holes_mm.map(([x, y], hole) => (
        <li key={`${x} ${y}`} class="row between">
          <span>
            Hole at {fixed(x, 1)}, {fixed(y, 1)} mm
          </span>
          <Button
            icon="delete"
            label={`Close hole ${hole + 1}`}
            disabled={lookOnly.value}
            onClick={() => void fieldEdit({ name: 'remove_hole', hole })}
          />
        </li>
      ))}
    </ul>
  );
}
