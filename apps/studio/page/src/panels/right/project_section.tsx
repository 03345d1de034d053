// The project as a whole: title, what all rods share, and what came out.

import { hello, lookOnly, measures, plan, project } from '../../core/store';
import { fieldEdit } from '../edits';
import { materialChoices } from '../logic/materials';
import { fixed, withUnit } from '../logic/number_text';
import { Choice } from '../parts/choice';
import { Facts } from '../parts/facts';
import { Field } from '../parts/field';
import { Section } from '../parts/section';
import { TextField } from '../parts/text_field';

export function ProjectSection() {
  const now = project.value;
  if (!now || now.title === undefined) return null;
  return (
    <Section title="Project">
      <TextField
        label="Title"
        value={now.title}
        disabled={lookOnly.value}
        onCommit={(title) => fieldEdit({ name: 'set_title', title })}
      />
      {now.kind === 'structure' && <p class="note">A structure to look at. To change a design, open a plan.</p>}
    </Section>
  );
}

export function AllRodsSection() {
  const now = plan.value;
  if (!now) return null;
  return (
    <Section title="All rods">
      <Choice
        label="Material"
        value={now.material}
        options={materialChoices(hello.value?.materials.rods, now.material)}
        disabled={lookOnly.value}
        onChoose={(material) => void fieldEdit({ name: 'set_rods', material })}
      />
      <Field
        label="Edge length"
        unit="mm"
        digits={2}
        step={0.5}
        value={now.edge_length_mm}
        disabled={lookOnly.value}
        onCommit={(edge_length_mm) => fieldEdit({ name: 'set_rods', edge_length_mm })}
      />
      <Field
        label="Largest turn of an edge"
        unit="°"
        digits={0}
        step={1}
        value={now.max_turn_deg}
        disabled={lookOnly.value}
        onCommit={(max_turn_deg) => fieldEdit({ name: 'set_rods', max_turn_deg })}
      />
    </Section>
  );
}

export function MeasuresSection() {
  const now = measures.value;
  if (!now) return null;
  return (
    <Section title="Measures">
      <Facts
        of={[
          ['Height', withUnit(now.height_mm, 'mm', 1)],
          ['Box', `${now.box_mm.map((side) => fixed(side, 1)).join(' × ')}\u00a0mm`],
          ['Area of the fabric', withUnit(now.area_mm2 / 100, 'cm²', 1)],
          ['Length of all rods', withUnit(now.rod_length_mm, 'mm', 0)],
          ['Smallest stretch', fixed(now.smallest_stretch, 3)],
          ['Largest strain of rods', withUnit(100 * now.largest_strain, '%', 3)],
          ['Energy', withUnit(now.energy_mj, 'mJ')],
        ]}
      />
    </Section>
  );
}
