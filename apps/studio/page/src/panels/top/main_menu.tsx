// The menu that lists everything: groups on the left, the commands of one group on the right.

import { useState } from 'preact/hooks';
import { commands, type CommandGroup } from '../../core/commands';
import { Icon } from '../parts/icon';
import { CommandEntry, MenuList } from '../parts/menu_list';
import { Popover } from '../parts/popover';

const groups: readonly CommandGroup[] = ['File', 'Edit', 'Select', 'Draw', 'Explore', 'Shape', 'Make', 'Solve', 'View', 'Help'];

export function MainMenu() {
  return (
    <Popover
      role="menu"
      label="Menu of everything"
      class="brand"
      text={
        <>
          lissom
          <Icon name="down" />
        </>
      }
    >
      {(close) => <Groups close={close} />}
    </Popover>
  );
}

function Groups({ close }: { close: () => void }) {
  const filled = groups.filter((group) => commands().some((c) => c.group === group));
  const [shown, setShown] = useState(filled[0]);
  /** Whether the keyboard has gone over to the commands. */
  const [inside, setInside] = useState(false);
  const enter = (group: CommandGroup) => {
    setShown(group);
    setInside(true);
  };
  const back = () => {
    setInside(false);
    document.getElementById(`menu-group-${shown}`)?.focus();
  };
  return (
    <div class="menu-panes">
      <MenuList label="Groups" autoFocus onClose={close}>
        {filled.map((group) => (
          <button
            key={group}
            id={`menu-group-${group}`}
            type="button"
            class="menu-entry"
            role="menuitem"
            tabIndex={-1}
            aria-haspopup="menu"
            aria-expanded={group === shown}
            onFocus={() => {
              if (!inside) setShown(group);
            }}
            onPointerMove={() => {
              setInside(false);
              setShown(group);
            }}
            onClick={() => enter(group)}
            onKeyDown={(event) => {
              if (event.key === 'ArrowRight') enter(group);
            }}
          >
            <span class="menu-title">{group}</span>
            <Icon name="right" />
          </button>
        ))}
      </MenuList>
      {shown && (
        <MenuList key={`${shown}${inside}`} label={shown} autoFocus={inside} onBack={back} onClose={close}>
          {commands()
            .filter((c) => c.group === shown)
            .map((c) => (
              <CommandEntry key={c.id} of={c} onTaken={close} />
            ))}
        </MenuList>
      )}
    </div>
  );
}
