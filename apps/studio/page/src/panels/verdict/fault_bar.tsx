// What was refused last: what, where and what to do.

import { fault } from '../../core/store';
import { refusalText } from '../logic/words';
import { Button } from '../parts/button';
import { Icon } from '../parts/icon';

export function FaultBar() {
  const now = fault.value;
  // A lost connection stands in the verdict line.
  if (!now || now.code === 'lost') return null;
  return (
    <div class="fault" role="alert">
      <Icon name="trouble" />
      <p>
        {refusalText(now)} {now.where && <span class="soft">({now.where})</span>}
      </p>
      <Button icon="close" label="Dismiss" onClick={() => (fault.value = null)} />
    </div>
  );
}
