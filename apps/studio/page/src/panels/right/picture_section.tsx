// Pictures of the shape as it stands, with or without its legend, into the folder.

import { pictureFile, writePicture, writing } from '../make/write';
import { Button } from '../parts/button';
import { Section } from '../parts/section';

export function PictureSection() {
  return (
    <Section title="Pictures">
      {[true, false].map((legends) => (
        <Button key={String(legends)} icon="camera" disabled={writing.value !== ''} onClick={() => void writePicture(legends)}>
          Write {pictureFile(legends)} {legends ? 'with its legend' : 'without legend'}
        </Button>
      ))}
      <p class="small soft">Seen as now, twice the size on screen, on a transparent ground.</p>
    </Section>
  );
}
