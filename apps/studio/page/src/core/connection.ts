// The WebSocket to the engine. Every request gets a promise; when the connection is lost it is tried again, hello is said
// anew and the engine resends its whole state. What was under way is given up: its promises answer with code "lost".

import { applyEvent, applyPack, forgetShape, rememberBefore } from './apply';
import { note } from './latency';
import { decodePack } from './packs';
import type { Answer, Edit, EngineEvent, Hello, Pack, Request } from './protocol';
import { connection, dragging, fault, hello } from './store';

/** The part of WebSocket that is used, so that tests and dev/ can stand in for it. */
export interface Wire {
  binaryType: string;
  onopen: (() => void) | null;
  onclose: (() => void) | null;
  onmessage: ((message: { data: unknown }) => void) | null;
  send(text: string): void;
  close(): void;
}

const kFirstDelay = 250;
const kLongestDelay = 4000;

export class Connection {
  private wire: Wire | null = null;
  private nextId = 1;
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private delay = kFirstDelay;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private ended = false;
  /** Newest shape and preview not yet applied: of each only the last counts. */
  private readonly newest = new Map<string, Pack>();
  private scheduled = false;

  constructor(
    private readonly open: () => Wire,
    /** Runs a function before the next frame is drawn. */
    private readonly soon: (run: () => void) => void,
  ) {}

  start(): void {
    if (this.ended) return;
    const wire = this.open();
    this.wire = wire;
    wire.binaryType = 'arraybuffer';
    wire.onopen = () => void this.greet();
    wire.onmessage = ({ data }) => this.receive(data);
    wire.onclose = () => this.lost();
  }

  /** Ends for good: no further attempts. */
  end(): void {
    this.ended = true;
    clearTimeout(this.timer);
    this.wire?.close();
  }

  /** Requests that have not been answered yet. */
  get unanswered(): number {
    return this.waiting.size;
  }

  /** Never rejects: an answer that cannot come is `ok: false` with code "lost". */
  send(request: Request): Promise<Answer> {
    const id = this.nextId++;
    if (!this.wire || (connection.peek() !== 'open' && request.do !== 'hello')) return Promise.resolve(lostAnswer(id));
    rememberBefore(request);
    return new Promise((resolve) => {
      this.waiting.set(id, resolve);
      this.wire?.send(JSON.stringify({ id, ...request }));
    });
  }

  private async greet(): Promise<void> {
    const answer = await this.send({ do: 'hello', protocol: 1 });
    if (!answer.ok) {
      if (answer.error && answer.error.code !== 'lost') fault.value = answer.error;
      return;
    }
    this.delay = kFirstDelay;
    forgetShape();
    if (fault.peek()?.code === 'lost') fault.value = null;
    hello.value = answer as unknown as Hello;
    connection.value = 'open';
  }

  private receive(data: unknown): void {
    if (typeof data !== 'string') {
      this.take(decodePack(data as ArrayBuffer));
      return;
    }
    const message = JSON.parse(data) as Answer | EngineEvent;
    if ('event' in message) {
      applyEvent(message as EngineEvent);
      return;
    }
    const resolve = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    resolve?.(message);
  }

  private take(pack: Pack): void {
    if (pack.pack !== 'shape' && pack.pack !== 'preview') {
      // A shape that waits belongs to the mesh before this one.
      this.flush();
      applyPack(pack);
      return;
    }
    this.newest.set(pack.pack, pack);
    if (this.scheduled) return;
    this.scheduled = true;
    this.soon(() => this.flush());
  }

  private flush(): void {
    this.scheduled = false;
    const packs = [...this.newest.values()];
    this.newest.clear();
    for (const pack of packs) {
      const start = performance.now();
      applyPack(pack);
      note('apply', performance.now() - start);
    }
  }

  private lost(): void {
    this.wire = null;
    if (connection.peek() === 'open') connection.value = 'lost';
    dragging.value = 0;
    const waiting = [...this.waiting];
    this.waiting.clear();
    for (const [id, resolve] of waiting) resolve(lostAnswer(id));
    if (this.ended) return;
    this.timer = setTimeout(() => this.start(), this.delay);
    this.delay = Math.min(2 * this.delay, kLongestDelay);
  }
}

function lostAnswer(id: number): Answer {
  const message = 'The engine does not answer.';
  return { id, ok: false, error: { code: 'lost', where: '', message, hint: 'Start lissom studio again; the page reconnects by itself.' } };
}

let engine: Connection | null = null;

/** Sets what send() goes through; main.tsx does it once. */
export function connect(to: Connection): void {
  engine = to;
  to.start();
}

/** Sends a request; a refusal is shown as store.fault unless `quiet`. Always resolves. */
export async function send(request: Request, quiet = false): Promise<Answer> {
  const answer = engine ? await engine.send(request) : lostAnswer(0);
  if (!answer.ok && answer.error && !quiet) fault.value = answer.error;
  return answer;
}

/** Sends one edit: one step of history. */
export function edit(change: Edit): Promise<Answer> {
  return send({ do: 'edit', edit: change });
}

/** Requests without an answer, for tests. */
export function waitingRequests(): number {
  return engine?.unanswered ?? 0;
}
