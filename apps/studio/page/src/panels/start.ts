// What has to be there before the page is drawn.

import { registerPanelCommands } from './commands';
import { keepSettings } from './settings';

export function startPanels(storage: Storage): void {
  registerPanelCommands();
  keepSettings(storage);
}
