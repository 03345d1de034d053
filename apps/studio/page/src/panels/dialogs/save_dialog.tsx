// A name for the file.

import { useState } from 'preact/hooks';
import { hello, project } from '../../core/store';
import { save, saveRefusal } from '../files';
import { refusalText } from '../logic/words';
import { documentName, fileStem } from '../logic/file_names';
import { Button } from '../parts/button';
import { closeDialog, Modal } from '../parts/modal';

export function SaveDialog() {
  const now = project.value;
  const [name, setName] = useState(`${fileStem(now?.file || now?.name || 'design')}.lissom`);
  const refusal = saveRefusal.value;
  const close = () => {
    saveRefusal.value = null;
    closeDialog('save');
  };
  const take = async (replace = false) => {
    const file = documentName(name);
    if (file === '') return;
    const answer = await save(file, replace);
    if (answer?.ok) close();
  };
  return (
    <Modal
      title="Save as"
      onClose={close}
      actions={
        <>
          <Button onClick={close}>Cancel</Button>
          {refusal && <Button onClick={() => void take(true)}>Replace it</Button>}
          <Button class="primary" icon="save" disabled={name.trim() === ''} onClick={() => void take()}>
            Save
          </Button>
        </>
      }
    >
      <div class="stack">
        <label for="save-name">Name of the file, in {hello.value?.folder || 'the folder of the studio'}</label>
        <input
          id="save-name"
          class="entry"
          type="text"
          autocomplete="off"
          spellcheck={false}
          autofocus
          value={name}
          onInput={(event) => {
            saveRefusal.value = null;
            setName(event.currentTarget.value);
          }}
          onKeyDown={(event) => {
            event.stopPropagation();
            if (event.key === 'Enter') void take();
          }}
        />
        {refusal && (
          <p class="note warn" role="alert">
            {refusalText(refusal)}
          </p>
        )}
        <p class="small soft">Its history is kept beside it, so that undo goes on after the next start.</p>
      </div>
    </Modal>
  );
}
