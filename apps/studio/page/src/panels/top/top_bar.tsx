// The bar at the top: menu, file, modes, history, search, settings.

import { history } from '../../core/store';
import { dirty } from '../files';
import { sideShown, toggleSide } from '../layout_state';
import { Button, CommandButton } from '../parts/button';
import { FileMenu } from './file_menu';
import { MainMenu } from './main_menu';
import { ModeTabs } from './mode_tabs';
import { SettingsPopover } from './settings_popover';

export function TopBar() {
  return (
    <header class="top">
      <h1 class="visually-hidden">lissom studio</h1>
      <div class="top-start">
        <MainMenu />
        <FileMenu />
        {dirty.value && (
          <span class="unsaved" role="img" aria-label="Not saved yet" title="Not saved yet" />
        )}
      </div>
      <ModeTabs />
      <div class="top-end">
        <UndoRedo />
        <CommandButton id="help.commands" icon="search" />
        <SettingsPopover />
        <CommandButton id="help.keys" icon="help" />
        <Button
          icon="panel-left"
          label={sideShown('tree') ? 'Hide the tree' : 'Show the tree'}
          pressed={sideShown('tree')}
          onClick={() => toggleSide('tree')}
        />
        <Button
          icon="panel-right"
          label={sideShown('inspector') ? 'Hide the inspector' : 'Show the inspector'}
          pressed={sideShown('inspector')}
          onClick={() => toggleSide('inspector')}
        />
      </div>
    </header>
  );
}

/** They say what they would take back or do again. */
function UndoRedo() {
  const { steps, at } = history.value ?? { steps: [], at: 0 };
  const back = steps[at - 1];
  const forth = steps[at];
  return (
    <>
      <CommandButton id="edit.undo" icon="undo" hint={back && `Undo: ${back.title}`} />
      <CommandButton id="edit.redo" icon="redo" hint={forth && `Redo: ${forth.title}`} />
    </>
  );
}
