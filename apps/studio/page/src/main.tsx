import { render } from 'preact';
import { Connection, connect, type Wire } from './core/connection';
import { App } from './panels/app';
import { startPanels } from './panels/start';
import './style/index.css';

function openWire(): Wire {
  const address = new URL('live', location.href);
  address.protocol = address.protocol === 'https:' ? 'wss:' : 'ws:';
  return new WebSocket(address) as unknown as Wire;
}

startPanels(localStorage);
const root = document.getElementById('app');
if (root) render(<App />, root);
connect(new Connection(openWire, (run) => requestAnimationFrame(run)));
