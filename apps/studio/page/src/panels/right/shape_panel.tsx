// Pull the shape: take hold of a part, say where it should be, see what would change, and make it real.

import { beginHandle } from '../../core/handles';
import { fit, handleCenter, jobs, lookOnly, selection } from '../../core/store';
import { Button } from '../parts/button';
import { Section } from '../parts/section';
import { FitSection } from './fit_section';
import { HandleSection } from './handle_section';
import { SoftRadiusField } from './soft_radius_field';
import { StillRow } from './still_row';

export function ShapePanel() {
  const fitting = jobs.value.fit?.state === 'running';
  const held = handleCenter.value !== null;
  return (
    <>
      {!held && !fitting && <TakeHold />}
      {held && !fitting && <HandleSection />}
      {(fitting || fit.value) && <FitSection fitting={fitting} />}
    </>
  );
}

function TakeHold() {
  const { points, nodes } = selection.value;
  const nothing = points.size + nodes.size === 0;
  return (
    <Section title="Take hold">
      <p class="soft">
        {nothing
          ? 'Click a place of the shape, or select points of the plan. What lies within the soft radius comes along.'
          : 'What lies within the soft radius of the selection comes along.'}
      </p>
      <SoftRadiusField />
      <StillRow />
      <Button icon="move-3d" class="primary" disabled={nothing || lookOnly.value} onClick={() => void beginHandle()}>
        Take hold
      </Button>
    </Section>
  );
}
