// The held part: typed place, turn and scale, what they would change, accept or cancel.

import { handle, handlePose, preview } from '../../core/store';
import { acceptHandle, cancelHandle, moveHandle } from '../../core/handles';
import type { HandleMove } from '../../core/protocol';
import { short } from '../logic/number_text';
import { sentence } from '../logic/words';
import { Button } from '../parts/button';
import { Facts } from '../parts/facts';
import { Field } from '../parts/field';
import { Section } from '../parts/section';
import { Changes } from './changes';
import { SoftRadiusField } from './soft_radius_field';
import { StillRow } from './still_row';

const axes = ['x', 'y', 'z'] as const;

export function HandleSection() {
  const held = handle.value;
  const answer = preview.value;
  return (
    <>
      <Section title="Handle">
        <SoftRadiusField />
        <StillRow />
        <PoseFields />
        {answer?.stale && (
          <p class="note warn">
            {held?.stale && held.sentence
              ? sentence(held.sentence)
              : 'Pulled far: the linear answer no longer holds. Accept it and go on from the shape that comes out.'}
          </p>
        )}
        <div class="row">
          <Button icon="check" class="primary" keys={['Enter']} label="Fit the design to this target" onClick={acceptHandle}>
            Accept
          </Button>
          <Button icon="close" keys={['Escape']} label="Let go" onClick={cancelHandle}>
            Cancel
          </Button>
        </div>
      </Section>
      {answer && (
        <Section title="What will change">
          <Facts
            of={[
              ['Distance left to the target', `${short(answer.rms_mm)} mm`],
              ['Force left by the linear answer', answer.residual_n === null ? 'cannot be built' : `${short(answer.residual_n, 2)} N`],
            ]}
          />
          <Changes of={answer.changes} />
        </Section>
      )}
    </>
  );
}

function PoseFields() {
  const pose = handlePose.value;
  const move = (change: Partial<HandleMove>) => {
    moveHandle({ ...handlePose.peek(), ...change });
    return null;
  };
  return (
    <>
      {axes.map((axis, k) => (
        <Field
          key={`move ${axis}`}
          label={`Move along ${axis}`}
          unit="mm"
          digits={2}
          step={0.5}
          initial={0}
          value={pose.move_mm[k]}
          onPreview={(value) => move({ move_mm: replaced(handlePose.peek().move_mm, k, value) })}
          onCommit={(value) => move({ move_mm: replaced(handlePose.peek().move_mm, k, value) })}
        />
      ))}
      {axes.map((axis, k) => (
        <Field
          key={`turn ${axis}`}
          label={`Turn about ${axis}`}
          unit="°"
          digits={1}
          step={1}
          initial={0}
          value={pose.turn_deg[k]}
          onPreview={(value) => move({ turn_deg: replaced(handlePose.peek().turn_deg, k, value) })}
          onCommit={(value) => move({ turn_deg: replaced(handlePose.peek().turn_deg, k, value) })}
        />
      ))}
      <Field
        label="Scale"
        unit="%"
        digits={0}
        step={1}
        initial={100}
        value={100 * pose.scale}
        onPreview={(value) => move({ scale: value / 100 })}
        onCommit={(value) => move({ scale: value / 100 })}
      />
    </>
  );
}

function replaced(of: readonly [number, number, number], k: number, value: number): [number, number, number] {
  const next: [number, number, number] = [...of];
  next[k] = value;
  return next;
}
