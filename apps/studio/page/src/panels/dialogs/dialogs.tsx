// The one dialog that is open.

import { dialog } from '../../core/store';
import { leaving } from '../files';
import { AboutDialog } from './about_dialog';
import { CommandSearch } from './command_search';
import { KeySheet } from './key_sheet';
import { LeaveDialog } from './leave_dialog';
import { SaveDialog } from './save_dialog';
import { StartDialog } from './start_dialog';

export function AppDialogs() {
  return (
    <>
      <Open />
      {leaving.value && <LeaveDialog />}
    </>
  );
}

function Open() {
  switch (dialog.value) {
    case 'commands':
      return <CommandSearch />;
    case 'keys':
      return <KeySheet />;
    case 'start':
      return <StartDialog />;
    case 'save':
      return <SaveDialog />;
    case 'about':
      return <AboutDialog />;
    default:
      return null;
  }
}
