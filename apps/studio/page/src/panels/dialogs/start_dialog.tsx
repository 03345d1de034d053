// Where work begins: templates, files of the folder, designs that come with lissom.

import { useEffect, useState } from 'preact/hooks';
import { send } from '../../core/connection';
import type { FilesAnswer } from '../../core/protocol';
import { hello } from '../../core/store';
import { beginWith, openFile } from '../files';
import { agoText, bytesText, counted } from '../logic/number_text';
import { drawingPath, kindText, openable, titleOf, type Drawing } from '../logic/start_entries';
import { closeDialog, Modal } from '../parts/modal';

export function StartDialog() {
  const [answer, setAnswer] = useState<FilesAnswer | null>(null);
  useEffect(() => {
    void send({ do: 'files' }).then((got) => {
      if (got.ok) setAnswer(got as unknown as FilesAnswer);
    });
  }, []);
  return (
    <Modal title="Begin" class="wide" onClose={() => closeDialog('start')}>
      <div class="start">
        <section aria-labelledby="start-templates">
          <h3 id="start-templates">New, from a template</h3>
          <ul class="cards">
            {hello.value?.templates.map(({ name, title, sentence, lines_mm }) => (
              <Card key={name} title={title} text={sentence} drawing={lines_mm ?? []} onTake={() => void beginWith(name)} />
            ))}
          </ul>
        </section>
        <section aria-labelledby="start-designs">
          <h3 id="start-designs">Designs that come with lissom</h3>
          <ul class="cards">
            {answer?.designs.map((design) => (
              <Card
                key={design.name}
                title={design.title || titleOf(design.name)}
                text={design.points > 0 ? counted(design.points, 'point') : 'to look at'}
                drawing={design.lines_mm ?? []}
                onTake={() => void openFile({ design: design.name })}
              />
            ))}
          </ul>
        </section>
        <section aria-labelledby="start-files">
          <h3 id="start-files">In {hello.value?.folder || 'the folder of the studio'}</h3>
          {answer && <Files answer={answer} />}
        </section>
      </div>
    </Modal>
  );
}

function Files({ answer }: { answer: FilesAnswer }) {
  const files = openable(answer.files, answer.recent);
  if (files.length === 0) return <p class="soft">No file to open yet.</p>;
  return (
    <ul class="file-list">
      {files.map((file) => (
        <li key={file.name}>
          <button type="button" class="place-row" onClick={() => void openFile({ file: file.name })}>
            <span>{file.name}</span>
            <span class="soft small">
              {answer.recent.includes(file.name) && 'recent, '}
              {kindText(file.kind)}, {bytesText(file.bytes)}
              {Number.isFinite(Number(file.modified)) && `, ${agoText(Date.now() / 1000 - Number(file.modified))}`}
            </span>
          </button>
        </li>
      ))}
    </ul>
  );
}

function Card({ title, text, drawing, onTake }: { title: string; text: string; drawing: Drawing; onTake: () => void }) {
  const { path, viewBox } = drawingPath(drawing);
  return (
    <li>
      <button type="button" class="card" onClick={onTake}>
        <svg class="thumbnail" viewBox={viewBox} aria-hidden="true">
          <path d={path} />
        </svg>
        <strong>{title}</strong>
        {text && <span class="small soft">{text}</span>}
      </button>
    </li>
  );
}
