// The newest frame of a stream and the buffers it leaves in. Decoding writes into one grid of int16; positions are made
// of it only when a buffer is at hand, so that a viewer that draws slowly gets the newest frame and none in between.

import { dequantise, type FrameGrid } from './frames';

export interface Moment {
  epoch: number;
  seq: number;
  step: number;
  time: number;
}

/** Buffers that travel between the worker and the page: one is shown while the other is filled. */
const kBuffers = 2;

export class FrameSlot {
  private readonly free_: Float32Array<ArrayBuffer>[] = [];
  private newest_: { grid: Int16Array; moment: Moment } | null = null;

  constructor(
    private readonly numbers_: number,
    private readonly grid_: FrameGrid,
    private readonly deliver_: (positions: Float32Array<ArrayBuffer>, moment: Moment) => void,
  ) {
    for (let i = 0; i < kBuffers; ++i) this.free_.push(new Float32Array(numbers_));
  }

  /** Takes a decoded frame; `grid` may be the decoder's own memory and is read before the next put at the latest. */
  put(grid: Int16Array, moment: Moment): void {
    this.newest_ = { grid, moment };
    this.hand();
  }

  /** A buffer comes back. One of another length is of an older topology and is dropped. */
  giveBack(buffer: Float32Array<ArrayBuffer>): void {
    if (buffer.length !== this.numbers_ || this.free_.length >= kBuffers) return;
    this.free_.push(buffer);
    this.hand();
  }

  private hand(): void {
    if (!this.newest_ || this.free_.length === 0) return;
    const positions = this.free_.pop()!;
    const { grid, moment } = this.newest_;
    this.newest_ = null;
    dequantise(grid, this.grid_, positions);
    this.deliver_(positions, moment);
  }
}
