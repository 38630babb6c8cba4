// What the page and its stream worker say to each other.

import type { ClothTopology } from './frames';
import type { Moment } from './FrameSlot';
import type { StreamConnection } from './JobStream';
import type { StreamText, StreamWord } from './types';

/** `watch` numbers tell answers for the job that is shown from late ones for the job before. */
export type ToWorker =
  | { type: 'watch'; watch: number; url: string }
  | { type: 'leave' }
  | { type: 'poke' }
  | { type: 'say'; word: StreamWord }
  | { type: 'buffer'; positions: Float32Array<ArrayBuffer> };

export type FromWorker =
  | { type: 'connection'; watch: number; connection: StreamConnection }
  | { type: 'text'; watch: number; message: StreamText }
  | { type: 'topology'; watch: number; topology: ClothTopology }
  | { type: 'frame'; watch: number; positions: Float32Array<ArrayBuffer>; moment: Moment };
