import { render } from 'preact';
import { registerCommands } from './commands';
import { Connection, connect, type Wire } from './core/connection';
import { holdInShape } from './core/handle_session';
import { App } from './panels/app';
import { startPanels } from './panels/start';
import { installTestHook } from './test_hook';
import { listenKeys } from './view/keyboard';
import './style/index.css';

function openWire(): Wire {
  const address = new URL('live', location.href);
  address.protocol = address.protocol === 'https:' ? 'wss:' : 'ws:';
  return new WebSocket(address) as unknown as Wire;
}

connect(new Connection(openWire, (run) => requestAnimationFrame(run)));
registerCommands();
startPanels(localStorage);
holdInShape();
listenKeys();
installTestHook(window as never);
const root = document.getElementById('app');
if (root) render(<App />, root);
