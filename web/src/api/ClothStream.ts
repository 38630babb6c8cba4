// The page's end of the stream worker: one job is watched at a time.

import type { ClothTopology } from './frames';
import type { Moment } from './FrameSlot';
import type { StreamConnection } from './JobStream';
import type { FromWorker, ToWorker } from './messages';
import type { StreamText, StreamWord } from './types';

export interface WorkerPort {
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
  postMessage(message: ToWorker, transfer?: Transferable[]): void;
}

export interface ClothStreamHandlers {
  connection(connection: StreamConnection): void;
  text(message: StreamText): void;
  topology(topology: ClothTopology): void;
  /** Gives back the buffer that is no longer shown, if any. */
  frame(positions: Float32Array<ArrayBuffer>, moment: Moment): Float32Array | null;
}

export class ClothStream {
  private watch_ = 0;

  constructor(
    private readonly port_: WorkerPort,
    private readonly handlers_: ClothStreamHandlers,
  ) {
    port_.onmessage = ({ data }) => this.receive(data);
  }

  watch(url: string): void {
    this.watch_ += 1;
    this.port_.postMessage({ type: 'watch', watch: this.watch_, url });
  }

  leave(): void {
    this.watch_ += 1;
    this.port_.postMessage({ type: 'leave' });
  }

  poke(): void {
    this.port_.postMessage({ type: 'poke' });
  }

  /** Says something to the drape that is watched. */
  say(word: StreamWord): void {
    this.port_.postMessage({ type: 'say', word });
  }

  private receive(message: FromWorker): void {
    if (message.watch !== this.watch_) return;
    switch (message.type) {
      case 'connection':
        return this.handlers_.connection(message.connection);
      case 'text':
        return this.handlers_.text(message.message);
      case 'topology':
        return this.handlers_.topology(message.topology);
      case 'frame':
        return this.take(message.positions, message.moment);
    }
  }

  private take(positions: Float32Array<ArrayBuffer>, moment: Moment): void {
    const before = this.handlers_.frame(positions, moment) as Float32Array<ArrayBuffer> | null;
    if (before) this.port_.postMessage({ type: 'buffer', positions: before }, [before.buffer]);
  }
}
