// The WebSocket of one job that stays connected: it opens, hands on what comes, and after a loss tries again with
// growing pauses until it is told to leave or the drape has ended. Knows nothing of frames or of the page.

import type { JobState } from './types';

/** The part of a WebSocket that is used here, so that tests can stand in for it. */
export interface Socket {
  binaryType: string;
  onopen: ((event: never) => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  onerror: ((event: never) => void) | null;
  send(data: string): void;
  close(code?: number, reason?: string): void;
}

export interface Clock {
  after(ms: number, what: () => void): number;
  cancel(id: number): void;
  /** In [0, 1): keeps many viewers from coming back in the same instant. */
  random(): number;
}

export type StreamConnection =
  | { state: 'connecting' }
  | { state: 'open' }
  | { state: 'lost'; attempt: number; retryMs: number }
  | { state: 'refused'; code: number; reason: string }
  | { state: 'closed' };

export interface StreamHandlers {
  connection(connection: StreamConnection): void;
  text(message: { type: string }): void;
  binary(bytes: Uint8Array): void;
}

const kFinalStates: readonly string[] = ['succeeded', 'failed', 'cancelled'] satisfies JobState[];
const kFirstPause = 250;
const kLongestPause = 5000;

/** Pause before attempt number `attempt` (from 1): 0.25 s, doubling up to 5 s, ± 20 %. */
export function backoff(attempt: number, random: number): number {
  const pause = Math.min(kLongestPause, kFirstPause * 2 ** Math.min(attempt - 1, 10));
  return Math.round(pause * (0.8 + 0.4 * random));
}

/** Close codes after which trying again would only be refused again: policy, no such job, not allowed. */
export const isRefusal = (code: number): boolean => code === 1008 || (code >= 4400 && code < 4500);

export class JobStream {
  private socket_: Socket | null = null;
  private timer_: number | null = null;
  private attempt_ = 0;
  private wanted_ = false;
  private open_ = false;
  private ended_ = false;

  constructor(
    private readonly url_: string,
    private readonly makeSocket_: (url: string) => Socket,
    private readonly clock_: Clock,
    private readonly handlers_: StreamHandlers,
  ) {}

  open(): void {
    this.wanted_ = true;
    this.connect();
  }

  /** Leaves for good. */
  close(): void {
    this.wanted_ = false;
    this.stopWaiting();
    this.drop();
    this.handlers_.connection({ state: 'closed' });
  }

  /** Says something to the service; without a connection nobody hears it. */
  say(message: object): void {
    if (this.open_) this.socket_?.send(JSON.stringify(message));
  }

  /** Tries now instead of after the pause, e.g. because the network is back. */
  poke(): void {
    if (this.timer_ === null) return;
    this.stopWaiting();
    this.connect();
  }

  /** Starts over on a new socket: the service then sends the topology and a key frame. */
  restart(): void {
    if (!this.wanted_ || this.ended_) return;
    this.drop();
    this.stopWaiting();
    this.lost();
  }

  private connect(): void {
    this.drop();
    this.handlers_.connection({ state: 'connecting' });
    const socket = this.makeSocket_(this.url_);
    this.socket_ = socket;
    socket.binaryType = 'arraybuffer';
    socket.onmessage = (event) => this.receive(event.data);
    socket.onopen = () => {
      this.open_ = true;
      this.handlers_.connection({ state: 'open' });
    };
    socket.onclose = (event) => this.closed(socket, event.code, event.reason);
  }

  private receive(data: unknown): void {
    this.attempt_ = 0; // only a connection that says something counts as a good one
    if (typeof data === 'string') {
      const message = parse(data);
      if (!message) return;
      // A server that stops ends the stream of a drape that has not ended; it is worth coming back for.
      if (message.type === 'ended') this.ended_ = kFinalStates.includes(message.state ?? '');
      this.handlers_.text(message);
    } else if (data instanceof ArrayBuffer) {
      this.handlers_.binary(new Uint8Array(data));
    }
  }

  private closed(socket: Socket, code: number, reason: string): void {
    if (socket !== this.socket_ || !this.wanted_) return;
    this.drop();
    if (this.ended_) return this.handlers_.connection({ state: 'closed' });
    if (isRefusal(code)) return this.handlers_.connection({ state: 'refused', code, reason });
    this.lost();
  }

  private lost(): void {
    this.attempt_ += 1;
    const retryMs = backoff(this.attempt_, this.clock_.random());
    this.handlers_.connection({ state: 'lost', attempt: this.attempt_, retryMs });
    this.timer_ = this.clock_.after(retryMs, () => {
      this.timer_ = null;
      this.connect();
    });
  }

  private stopWaiting(): void {
    if (this.timer_ !== null) this.clock_.cancel(this.timer_);
    this.timer_ = null;
  }

  private drop(): void {
    const socket = this.socket_;
    this.socket_ = null;
    this.open_ = false;
    if (!socket) return;
    socket.onopen = null;
    socket.onmessage = null;
    socket.onclose = null;
    socket.onerror = null;
    socket.close();
  }
}

function parse(data: string): { type: string; state?: string } | null {
  try {
    const message = JSON.parse(data) as { type?: unknown } | null;
    return typeof message?.type === 'string' ? (message as { type: string }) : null;
  } catch {
    return null;
  }
}
