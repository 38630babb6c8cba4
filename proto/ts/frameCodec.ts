// Frames of moving cloth: reading them into arrays that are there already, and writing them (for tests and for
// stand-ins of the service). The layout stands in ../frames.md.

import {
  FrameError,
  MessageType,
  float32At,
  int32At,
  kPrefixSize,
  malformed,
  messageType,
  uint32At,
  writePrefix,
} from './message';

export interface FrameHeader {
  key: boolean;
  epoch: number;
  seq: number;
  /** Substeps of the drape. */
  step: number;
  /** Simulated seconds. */
  time: number;
}

/** Three numbers a vertex, x y z: metres = origin + step · number, by the topology's grid. */
export interface DecodedFrame {
  header: FrameHeader;
  grid: Int16Array;
}

/** Where the grid lies: metres = origin + step · number. */
export interface FrameGrid {
  origin: [number, number, number];
  /** Metres. */
  step: number;
}

const kHeaderSize = 24;
const kAxes = 3;
const kBlock = 16;
const kMaxWidth = 16;
const kWidthBits = 0x1f;
const kAlongOrder = 0x20;

const headCount = (vertexCount: number): number => kAxes * Math.ceil(vertexCount / kBlock);

export const emptyFrameHeader = (): FrameHeader => ({ key: false, epoch: 0, seq: 0, step: 0, time: 0 });

/**
 * Reads the header and proves that the blocks fill the message exactly, so that nothing after needs to look at its
 * end. Returns the number of vertices. Throws FrameError.
 */
function readHeader(bytes: Uint8Array, header: FrameHeader): number {
  const type = messageType(bytes);
  if (type === MessageType.topology) throw malformed('a frame was expected, and this is a topology');
  if (bytes.length < kHeaderSize) throw malformed('the frame ends early');
  const vertexCount = uint32At(bytes, 20);
  const bodyAt = kHeaderSize + headCount(vertexCount);
  if (bytes.length < bodyAt) throw malformed('the frame ends early');
  const time = float32At(bytes, 16);
  if (!Number.isFinite(time)) throw malformed('the frame’s time is no number');
  let end = bodyAt;
  for (let at = kHeaderSize; at < bodyAt; ++at) {
    const head = bytes[at]!;
    const width = head & kWidthBits;
    if (width > kMaxWidth || head > (kAlongOrder | kWidthBits)) {
      throw malformed('a block of the frame has no possible width');
    }
    end += 2 * width;
  }
  if (bytes.length !== end) throw malformed('the frame is longer or shorter than its blocks');
  header.key = type === MessageType.key;
  header.epoch = uint32At(bytes, kPrefixSize - 4);
  header.seq = uint32At(bytes, kPrefixSize);
  header.step = int32At(bytes, 12);
  header.time = time;
  return vertexCount;
}

/** Each axis's last number of the block before, while a frame is read; made once. */
const previous = new Int32Array(kAxes);

/** Adds what the blocks say to `before` (nothing: to zero) and puts it into `out`, which may be the same array. */
function applyBlocks(bytes: Uint8Array, vertexCount: number, before: Int16Array | null, out: Int16Array): void {
  let headAt = kHeaderSize;
  let bodyAt = kHeaderSize + headCount(vertexCount);
  const end = kAxes * vertexCount;
  previous.fill(0);
  for (let first = 0; first < end; first += kAxes * kBlock) {
    for (let axis = 0; axis < kAxes; ++axis) {
      const head = bytes[headAt++]!;
      const width = head & kWidthBits;
      const mask = (1 << width) - 1;
      const along = (head & kAlongOrder) !== 0 ? -1 : 0;
      const past = Math.min(first + kAxes * kBlock, end);
      let number = previous[axis]!;
      let bits = 0;
      let bitCount = 0;
      let at = bodyAt;
      for (let i = first + axis; i < past; i += kAxes) {
        if (bitCount < width) {
          bits |= (bytes[at]! | (bytes[at + 1]! << 8)) << bitCount;
          at += 2;
          bitCount += 16;
        }
        const code = bits & mask;
        bits >>>= width;
        bitCount -= width;
        number = (number & along) + ((code >>> 1) ^ -(code & 1));
        out[i] = before === null ? number : before[i]! + number; // stores modulo 2¹⁶
      }
      previous[axis] = number;
      bodyAt += 2 * width;
    }
  }
}

/**
 * Reads a key, or a delta against `before`, of which it can only check the length: FrameReader also checks epoch and
 * order. The frame goes into `into` when its grid has the right length (it may be `before`), else into a new one.
 * Throws FrameError, and then `into` is as it was.
 */
export function decodeFrame(bytes: Uint8Array, before: Int16Array, into?: DecodedFrame): DecodedFrame {
  const header = emptyFrameHeader();
  const vertexCount = readHeader(bytes, header);
  const length = kAxes * vertexCount;
  if (!header.key && before.length !== length) {
    throw new FrameError('frame.wrong_base', 'the delta is against a frame of another size; wait for a key');
  }
  const frame = into && into.grid.length === length ? into : { header, grid: new Int16Array(length) };
  Object.assign(frame.header, header);
  applyBlocks(bytes, vertexCount, header.key ? null : before, frame.grid);
  return frame;
}

/**
 * One end of a stream: keeps the newest frame in arrays that it makes once, and takes only what fits it.
 */
export class FrameReader {
  /** The newest frame's numbers, three a vertex; always the same array. */
  readonly grid: Int16Array;
  private header_ = emptyFrameHeader();
  private next_ = emptyFrameHeader();
  private hasFrame_ = false;

  constructor(
    private readonly epoch_: number,
    private readonly vertexCount_: number,
  ) {
    this.grid = new Int16Array(kAxes * vertexCount_);
  }

  /** Of the newest frame; null before the first key. Valid until the next read. */
  get header(): Readonly<FrameHeader> | null {
    return this.hasFrame_ ? this.header_ : null;
  }

  /**
   * Takes a key of this epoch, or the delta that follows the frame it holds. Throws FrameError (frame.wrong_base for
   * a gap or another epoch), and then holds what it held.
   */
  read(bytes: Uint8Array): void {
    const next = this.next_;
    const vertexCount = readHeader(bytes, next);
    if (next.epoch !== this.epoch_) {
      throw new FrameError('frame.wrong_base', 'the frame is of another epoch than the topology');
    }
    if (!next.key && (!this.hasFrame_ || next.seq !== (this.header_.seq + 1) >>> 0)) {
      throw new FrameError('frame.wrong_base', 'the delta does not follow the frame before; wait for a key');
    }
    if (vertexCount !== this.vertexCount_) throw malformed('the frame has not the topology’s number of vertices');
    applyBlocks(bytes, vertexCount, next.key ? null : this.grid, this.grid);
    this.next_ = this.header_;
    this.header_ = next;
    this.hasFrame_ = true;
  }
}

/** Metres of every number, into `out` of the same length. */
export function dequantise(numbers: Int16Array, grid: FrameGrid, out: Float32Array): void {
  const [x, y, z] = grid.origin;
  const step = grid.step;
  for (let i = 0; i + 2 < numbers.length; i += kAxes) {
    out[i] = x + step * numbers[i]!;
    out[i + 1] = y + step * numbers[i + 1]!;
    out[i + 2] = z + step * numbers[i + 2]!;
  }
}

/** A frame by itself. */
export function encodeKey(header: Omit<FrameHeader, 'key'>, grid: Int16Array): Uint8Array {
  return encode(MessageType.key, header, grid, null);
}

/** A frame against the one before it (seq − 1 of the same epoch). */
export function encodeDelta(header: Omit<FrameHeader, 'key'>, grid: Int16Array, before: Int16Array): Uint8Array {
  if (before.length !== grid.length) throw new RangeError('a delta needs two frames of the same length');
  return encode(MessageType.delta, header, grid, before);
}

function encode(
  type: MessageType,
  header: Omit<FrameHeader, 'key'>,
  grid: Int16Array,
  before: Int16Array | null,
): Uint8Array {
  const vertexCount = grid.length / kAxes;
  if (!Number.isInteger(vertexCount)) throw new RangeError('a frame has three numbers a vertex');
  const heads = headCount(vertexCount);
  const bytes = new Uint8Array(kHeaderSize + heads * (1 + 2 * kMaxWidth));
  const view = new DataView(bytes.buffer);
  writePrefix(view, type, header.epoch);
  view.setUint32(8, header.seq, true);
  view.setInt32(12, header.step, true);
  view.setFloat32(16, header.time, true);
  view.setUint32(20, vertexCount, true);
  let bodyAt = kHeaderSize + heads;
  for (let b = 0; b < heads; ++b) {
    const block = chooseBlock(grid, before, Math.floor(b / kAxes) * kBlock, b % kAxes);
    bytes[kHeaderSize + b] = block.head;
    packBlock(block.codes, block.head & kWidthBits, bytes, bodyAt);
    bodyAt += 2 * (block.head & kWidthBits);
  }
  return bytes.slice(0, bodyAt);
}

const zigzag = (difference: number): number => {
  const signed = (difference << 16) >> 16;
  return ((signed << 1) ^ (signed >> 31)) & 0xffff;
};

const widthOf = (codes: number[]): number => 32 - Math.clz32(codes.reduce((all, code) => all | code, 0));

/** The sixteen codes of one axis from vertex `first` on, the narrower way; plain when both are as wide. */
function chooseBlock(
  grid: Int16Array,
  before: Int16Array | null,
  first: number,
  axis: number,
): { head: number; codes: number[] } {
  const change = (vertex: number): number => {
    const i = kAxes * vertex + axis;
    return vertex < 0 ? 0 : grid[i]! - (before === null ? 0 : before[i]!);
  };
  const plain: number[] = [];
  const along: number[] = [];
  for (let v = first; v < first + kBlock; ++v) {
    const there = kAxes * v < grid.length;
    plain.push(there ? zigzag(change(v)) : 0);
    along.push(there ? zigzag(change(v) - change(v - 1)) : 0);
  }
  const plainWidth = widthOf(plain);
  const alongWidth = widthOf(along);
  return alongWidth < plainWidth
    ? { head: alongWidth | kAlongOrder, codes: along }
    : { head: plainWidth, codes: plain };
}

/** One code's bits after the other's, the lowest first. */
function packBlock(codes: number[], width: number, bytes: Uint8Array, at: number): void {
  codes.forEach((code, i) => {
    for (let b = 0; b < width; ++b) {
      const bit = i * width + b;
      bytes[at + (bit >> 3)]! |= ((code >> b) & 1) << (bit & 7);
    }
  });
}
