// A job's stream as it arrives: text passes through, the topology opens an epoch, frames are decoded into its slot.
// Runs in the worker; has no other state than the stream's.

import { decodeTopology, FrameReader, MessageType, messageType, type ClothTopology } from './frames';
import { FrameSlot, type Moment } from './FrameSlot';
import { JobStream, type Clock, type Socket, type StreamConnection } from './JobStream';
import type { StreamText, StreamWord } from './types';

export interface ReceiverHandlers {
  connection(connection: StreamConnection): void;
  text(message: StreamText): void;
  topology(topology: ClothTopology): void;
  frame(positions: Float32Array<ArrayBuffer>, moment: Moment): void;
}

export class StreamReceiver {
  private readonly stream_: JobStream;
  private reader_: FrameReader | null = null;
  private slot_: FrameSlot | null = null;

  constructor(
    url: string,
    makeSocket: (url: string) => Socket,
    clock: Clock,
    private readonly handlers_: ReceiverHandlers,
  ) {
    this.stream_ = new JobStream(url, makeSocket, clock, {
      connection: (connection) => handlers_.connection(connection),
      text: (message) => handlers_.text(message as StreamText),
      binary: (bytes) => this.binary(bytes),
    });
  }

  open(): void {
    this.stream_.open();
  }

  close(): void {
    this.stream_.close();
  }

  poke(): void {
    this.stream_.poke();
  }

  say(word: StreamWord): void {
    this.stream_.say(word);
  }

  giveBack(positions: Float32Array<ArrayBuffer>): void {
    this.slot_?.giveBack(positions);
  }

  /** What cannot be read means that something was lost: on a new connection the service sends all that is needed. */
  private binary(bytes: Uint8Array): void {
    try {
      if (messageType(bytes) === MessageType.topology) this.begin(decodeTopology(bytes));
      else this.decode(bytes);
    } catch {
      this.stream_.restart();
    }
  }

  private begin(topology: ClothTopology): void {
    this.reader_ = new FrameReader(topology.epoch, topology.vertexCount);
    this.slot_ = new FrameSlot(3 * topology.vertexCount, topology, (positions, moment) =>
      this.handlers_.frame(positions, moment),
    );
    this.handlers_.topology(topology);
  }

  private decode(bytes: Uint8Array): void {
    if (!this.reader_ || !this.slot_) throw new Error('a frame before its topology');
    this.reader_.read(bytes);
    const { epoch, seq, step, time } = this.reader_.header!;
    this.slot_.put(this.reader_.grid, { epoch, seq, step, time });
  }
}
