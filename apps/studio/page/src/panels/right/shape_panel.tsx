// Pull the shape: take hold of a part, say where it should be, see what would change, and make it real.

import { beginHandle, setSoftRadius } from '../../core/handles';
import { fit, handleCenter, jobs, lookOnly, selection, softRadius } from '../../core/store';
import { Button } from '../parts/button';
import { Field } from '../parts/field';
import { Section } from '../parts/section';
import { FitSection } from './fit_section';
import { HandleSection } from './handle_section';

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
      <Field
        label="Soft radius"
        unit="mm"
        digits={1}
        step={1}
        range={[1, 100]}
        value={softRadius.value}
        onPreview={setSoftRadius}
        onCommit={(value) => {
          setSoftRadius(value);
          return null;
        }}
      />
      <Button icon="move-3d" class="primary" disabled={nothing || lookOnly.value} onClick={() => void beginHandle()}>
        Take hold
      </Button>
    </Section>
  );
}
