// The name of the file, and what can be done with files.

import { commands } from '../../core/commands';
import { send } from '../../core/connection';
import type { FilesAnswer } from '../../core/protocol';
import { project } from '../../core/store';
import { useEffect, useState } from 'preact/hooks';
import { CommandEntry, MenuEntry, MenuList } from '../parts/menu_list';
import { Popover } from '../parts/popover';
import { openFile } from '../files';

export function FileMenu() {
  const name = project.value?.file || project.value?.name || 'No file';
  return (
    <Popover role="menu" label="File menu" class="file-name" text={name}>
      {(close) => <Entries close={close} />}
    </Popover>
  );
}

function Entries({ close }: { close: () => void }) {
  const [recent, setRecent] = useState<string[]>([]);
  useEffect(() => {
    void send({ do: 'files' }, true).then((answer) => {
      if (answer.ok) setRecent((answer as unknown as FilesAnswer).recent.slice(0, 6));
    });
  }, []);
  return (
    <MenuList label="File" autoFocus onClose={close}>
      {commands()
        .filter((c) => c.group === 'File')
        .map((c) => (
          <CommandEntry key={c.id} of={c} onTaken={close} />
        ))}
      {recent.map((file) => (
        <MenuEntry
          key={file}
          title={file}
          aside="recent"
          onTake={() => {
            close();
            void openFile({ file });
          }}
        />
      ))}
    </MenuList>
  );
}
