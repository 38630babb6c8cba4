// The topology message: what does not change within an epoch of a drape's stream. The layout stands in ../frames.md.

import type { FrameGrid } from './frameCodec';
import { MessageType, float32At, kPrefixSize, malformed, messageType, uint32At, writePrefix } from './message';

export interface StreamPiece {
  id: string;
  firstVertex: number;
  vertexCount: number;
  /** Linear RGB. */
  colour: [number, number, number];
}

export interface Topology extends FrameGrid {
  epoch: number;
  vertexCount: number;
  pieces: StreamPiece[];
  /** Flat position of each vertex in its piece, x y, metres. */
  rest: Float32Array;
  /** Three vertices a triangle, counter-clockwise seen from the cloth's right side. */
  triangles: Uint32Array;
  /** Two vertices a pair that a seam joins. */
  sewn: Uint32Array;
}

const kHeaderSize = 56;
const kRestSize = 8; // bytes a vertex
const kPieceSize = 21; // bytes a piece, at least

/** Reads on from the front; throws FrameError where something is missing. */
class ByteReader {
  private at_: number;

  constructor(
    private readonly bytes_: Uint8Array,
    at: number,
  ) {
    this.at_ = at;
  }

  get left(): number {
    return this.bytes_.length - this.at_;
  }

  take(count: number): number {
    if (count > this.left) throw malformed('the topology ends early');
    const at = this.at_;
    this.at_ += count;
    return at;
  }

  uint32(): number {
    return uint32At(this.bytes_, this.take(4));
  }

  /** A finite number. */
  float32(what: string): number {
    const value = float32At(this.bytes_, this.take(4));
    if (!Number.isFinite(value)) throw malformed(`${what} is no number`);
    return value;
  }

  varint(): number {
    let value = 0;
    for (let shift = 0; shift < 35; shift += 7) {
      const byte = this.bytes_[this.take(1)]!;
      if (shift === 28 && byte > 0x0f) break; // more than 32 bits
      value |= (byte & 0x7f) << shift;
      if (byte < 0x80) return value >>> 0;
    }
    throw malformed('an index of the topology has more than 32 bits');
  }

  text(): string {
    const length = this.varint();
    const at = this.take(length);
    return new TextDecoder().decode(this.bytes_.subarray(at, at + length));
  }

  /** A vertex, written as its difference to `from`. */
  vertex(from: number, vertexCount: number, what: string): number {
    const code = this.varint();
    const vertex = from + ((code >>> 1) ^ -(code & 1));
    if (vertex < 0 || vertex >= vertexCount) throw malformed(`${what} has a vertex that is not there`);
    return vertex;
  }
}

/** Every index in the result is that of a vertex, every number finite. Throws FrameError. */
export function decodeTopology(bytes: Uint8Array): Topology {
  if (messageType(bytes) !== MessageType.topology) {
    throw malformed('a topology was expected, and this is a frame');
  }
  if (bytes.length < kHeaderSize) throw malformed('the topology ends early');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const metres = (at: number): number => view.getFloat64(at, true);
  const origin: FrameGrid['origin'] = [metres(8), metres(16), metres(24)];
  const step = metres(32);
  const vertexCount = uint32At(bytes, 40);
  const triangleCount = uint32At(bytes, 44);
  const pieceCount = uint32At(bytes, 48);
  const sewnCount = uint32At(bytes, 52);
  const reader = new ByteReader(bytes, kHeaderSize);
  const fits = (count: number, size: number): boolean => count * size <= reader.left;
  // Nothing is made before what the counts promise can be there at all.
  const allFit =
    fits(vertexCount, kRestSize) && fits(triangleCount, 3) && fits(pieceCount, kPieceSize) && fits(sewnCount, 2);
  if (!allFit) {
    throw malformed('the topology ends early');
  }
  if (![...origin, step].every(Number.isFinite) || step <= 0) throw malformed('the topology’s grid is none');
  const rest = new Float32Array(2 * vertexCount);
  for (let i = 0; i < rest.length; ++i) rest[i] = reader.float32('a rest position');
  const pieces = Array.from({ length: pieceCount }, () => readPiece(reader, vertexCount));
  const triangles = readTriangles(reader, triangleCount, vertexCount);
  const sewn = readSewn(reader, sewnCount, vertexCount);
  if (reader.left !== 0) throw malformed('the topology is longer than it says');
  const epoch = uint32At(bytes, kPrefixSize - 4);
  return { epoch, origin, step, vertexCount, pieces, rest, triangles, sewn };
}

function readPiece(reader: ByteReader, vertices: number): StreamPiece {
  const firstVertex = reader.uint32();
  const vertexCount = reader.uint32();
  if (firstVertex + vertexCount > vertices) throw malformed('a piece has vertices that are not there');
  const colour: [number, number, number] = [0, 0, 0];
  for (let c = 0; c < 3; ++c) colour[c] = reader.float32('a piece’s colour');
  return { id: reader.text(), firstVertex, vertexCount, colour };
}

function readTriangles(reader: ByteReader, count: number, vertexCount: number): Uint32Array {
  const triangles = new Uint32Array(3 * count);
  let from = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    for (let c = 0; c < 3; ++c) {
      from = reader.vertex(from, vertexCount, 'a triangle');
      triangles[t + c] = from;
    }
    from = triangles[t]!;
  }
  return triangles;
}

function readSewn(reader: ByteReader, count: number, vertexCount: number): Uint32Array {
  const sewn = new Uint32Array(2 * count);
  for (let i = 0; i < sewn.length; ++i) {
    sewn[i] = reader.vertex(i < 2 ? 0 : sewn[i - 2]!, vertexCount, 'a sewn pair');
  }
  return sewn;
}

/** The message of a topology: for tests, and for stand-ins of the service. */
export function encodeTopology(topology: Topology): Uint8Array {
  const { rest, triangles, sewn, pieces } = topology;
  const head = new Uint8Array(kHeaderSize + 4 * rest.length);
  const view = new DataView(head.buffer);
  writePrefix(view, MessageType.topology, topology.epoch);
  [...topology.origin, topology.step].forEach((number, i) => view.setFloat64(8 + 8 * i, number, true));
  const counts = [topology.vertexCount, triangles.length / 3, pieces.length, sewn.length / 2];
  counts.forEach((count, i) => view.setUint32(40 + 4 * i, count, true));
  rest.forEach((number, i) => view.setFloat32(kHeaderSize + 4 * i, number, true));
  const tail: number[] = [];
  for (const piece of pieces) pushPiece(tail, piece);
  triangles.forEach((corner, i) => {
    const from = i % 3 > 0 ? triangles[i - 1]! : i > 0 ? triangles[i - 3]! : 0;
    pushDifference(tail, corner - from);
  });
  sewn.forEach((vertex, i) => pushDifference(tail, vertex - (i < 2 ? 0 : sewn[i - 2]!)));
  const bytes = new Uint8Array(head.length + tail.length);
  bytes.set(head);
  bytes.set(tail, head.length);
  return bytes;
}

function pushPiece(bytes: number[], piece: StreamPiece): void {
  const fixed = new DataView(new ArrayBuffer(20));
  fixed.setUint32(0, piece.firstVertex, true);
  fixed.setUint32(4, piece.vertexCount, true);
  piece.colour.forEach((c, i) => fixed.setFloat32(8 + 4 * i, c, true));
  const id = new TextEncoder().encode(piece.id);
  bytes.push(...new Uint8Array(fixed.buffer));
  pushVarint(bytes, id.length);
  bytes.push(...id);
}

function pushVarint(bytes: number[], value: number): void {
  let rest = value >>> 0;
  for (; rest >= 0x80; rest >>>= 7) bytes.push((rest & 0x7f) | 0x80);
  bytes.push(rest);
}

function pushDifference(bytes: number[], difference: number): void {
  pushVarint(bytes, (difference << 1) ^ (difference >> 31));
}

