import { render } from 'preact';
import { registerCommands } from './commands';
import { Connection, connect, type Wire } from './core/connection';
import { holdInShape } from './core/handle_session';
import { App } from './panels/app';
import { startPanels } from './panels/start';
import { installTestHook } from './test_hook';
import { listenKeys } from './view/keyboard';
import { prepareMachine } from './view/machine';
import './style/index.css';

function openWire(): Wire {
  const address = new URL('live', location.href);
  address.protocol = address.protocol === 'https:' ? 'wss:' : 'ws:';
  return new WebSocket(address) as unknown as Wire;
}

prepareMachine();
// Not before the next picture: what a picture's turn applies would be drawn only in the turn after it.
connect(new Connection(openWire, (run) => setTimeout(run, 0)));
registerCommands();
startPanels(localStorage);
holdInShape();
listenKeys();
installTestHook(window as never);
const root = document.getElementById('app');
if (root) render(<App />, root);
