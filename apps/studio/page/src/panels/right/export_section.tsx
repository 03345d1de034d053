// Files to make it from. Each button says what will be written and where.

import { hello, lookOnly, plan } from '../../core/store';
import { designStem, writeExport, writing, written } from '../make/write';
import { Button } from '../parts/button';
import { Section } from '../parts/section';

interface Format {
  format: string;
  what: string;
  /** Needs a plan. */
  flat: boolean;
}

const formats: readonly Format[] = [
  { format: 'svg', what: 'The plan at true size in mm, with names', flat: true },
  { format: 'dxf', what: 'The plan in mm, one layer each for rods and ghosts', flat: true },
  { format: 'stl', what: 'The rods as a solid, flat as they are printed, in mm', flat: false },
];

export function ExportSection() {
  const name = designStem();
  const folder = hello.value?.folder ?? '';
  return (
    <Section title="Write files">
      <p class="small soft">Into the folder {folder || 'of the studio'}.</p>
      {formats.map(({ format, what, flat }) => (
        <div key={format} class="stack tight">
          <Button icon="export" disabled={(flat && !plan.value) || writing.value !== ''} onClick={() => void writeExport(format)}>
            Write {name}.{format}
          </Button>
          <p class="small soft">{what}.</p>
        </div>
      ))}
      {writing.value && <p class="note">Writing {writing.value}.</p>}
      {!writing.value && written.value && <p class="note">{written.value}</p>}
      {lookOnly.value && <p class="small soft">This is only looked at; a plan can be written in every format.</p>}
    </Section>
  );
}
