// Found: the work of a session that ended before it was saved. A bar, not a dialog: looking comes first.

import { send } from '../../core/connection';
import { project } from '../../core/store';
import { agoText, counted } from '../logic/number_text';
import { Button } from '../parts/button';
import { Icon } from '../parts/icon';

export function RecoverBar() {
  const found = project.value?.recovery;
  if (!found) return null;
  const when = Number(found.when);
  return (
    <section class="notice warn" aria-label="Recovery">
      <Icon name="history" />
      <p>
        {found.name} has {counted(found.steps, 'step')} from a session that ended before saving
        {Number.isFinite(when) ? `, ${agoText(Date.now() / 1000 - when)}` : ''}.
      </p>
      <Button class="primary" onClick={() => void send({ do: 'recover', take: true })}>
        Take it up
      </Button>
      <Button onClick={() => void send({ do: 'recover', take: false })}>Let it go</Button>
    </section>
  );
}
