// How far around the held part others come along.

import { setSoftRadius } from '../../core/handles';
import { softRadius } from '../../core/store';
import { Field } from '../parts/field';

export function SoftRadiusField() {
  return (
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
  );
}
