// The cloth of the job that is shown: its topology and the newest positions, in one buffer at a time. Views subscribe
// and take the newest; nothing queues.

import type { ClothTopology } from '../api/frames';

export interface FrameMoment {
  epoch: number;
  seq: number;
  step: number;
  /** s of simulated time. */
  time: number;
}

export type ClothEvent = 'topology' | 'frame' | 'cleared';

export class LiveCloth {
  topology: ClothTopology | null = null;
  /** xyz of each vertex, m. The views read it in place; it is replaced with every frame. */
  positions: Float32Array | null = null;
  moment: FrameMoment | null = null;
  /** Frames taken since the job was opened. */
  frames = 0;

  /** Of a cloth of which no frame has come. */
  private coming_: ClothTopology | null = null;
  private readonly listeners_ = new Set<(event: ClothEvent) => void>();

  /** Returns how to unsubscribe. */
  listen(listener: (event: ClothEvent) => void): () => void {
    this.listeners_.add(listener);
    return () => this.listeners_.delete(listener);
  }

  clear(): void {
    this.topology = null;
    this.coming_ = null;
    this.positions = null;
    this.moment = null;
    this.frames = 0;
    this.tell('cleared');
  }

  /** What is seen stays in view until the first frame of another cloth: it must not blink. */
  setTopology(topology: ClothTopology): void {
    const same = this.topology?.vertexCount === topology.vertexCount && this.topology.epoch === topology.epoch;
    if (this.positions && !same) {
      this.coming_ = topology;
      return;
    }
    this.coming_ = null;
    this.topology = topology;
    this.tell('topology');
  }

  /** Takes the newest positions and gives back the buffer they replace, to be filled again. */
  setPositions(positions: Float32Array, moment: FrameMoment): Float32Array | null {
    const other = this.coming_;
    const before = other ? null : this.positions; // that of another cloth is of another size
    this.positions = positions;
    this.moment = moment;
    this.frames += 1;
    if (other) {
      this.coming_ = null;
      this.topology = other;
      this.tell('topology');
    }
    this.tell('frame');
    return before;
  }

  /** A view that breaks must not keep the others from going on, nor its buffer from going back to the worker. */
  private tell(event: ClothEvent): void {
    for (const listener of this.listeners_) {
      try {
        listener(event);
      } catch (error) {
        reportError(error);
      }
    }
  }
}

/** FNV-1a over the bits of all coordinates: whether anything moved, cheaply. */
export function positionsHash(positions: Float32Array): string {
  const words = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  let hash = 0x811c9dc5;
  for (const word of words) hash = Math.imul(hash ^ word, 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, '0');
}
