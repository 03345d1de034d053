// All commands of view and tools; panels add theirs (panels/commands.ts).

import { register } from '../core/commands';
import { editCommands } from './edit';
import { selectCommands } from './select';
import { viewCommands } from './view';
import { workCommands } from './work';

export function registerCommands(): void {
  register(...editCommands, ...selectCommands, ...workCommands, ...viewCommands);
}
