// Looks for other stable shapes of the same design; what is found stands in the strip under the shape.

import { send } from '../../core/connection';
import { branches, jobs, lookOnly } from '../../core/store';
import { sentence } from '../logic/words';
import { Button } from '../parts/button';
import { Section } from '../parts/section';

export function BranchesFinder() {
  const found = branches.value?.branches ?? [];
  const busy = jobs.value.branches?.state === 'running';
  return (
    <Section title="Other stable shapes" aside={found.length > 1 ? String(found.length) : ''}>
      {found.length === 0 && <p class="soft small">The same rods and fabric may rest in more than one shape.</p>}
      {found.length === 1 && <p>This design rests in one shape only, as far as was looked.</p>}
      {found.map((branch, k) => (
        <p key={k}>{sentence(branch.sentence)}</p>
      ))}
      <Button icon="compare" disabled={busy || lookOnly.value} onClick={() => void send({ do: 'branches' })}>
        {found.length === 0 ? 'Look for them' : 'Look again'}
      </Button>
    </Section>
  );
}
