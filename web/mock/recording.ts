// A recorded drape (toile drape … --trace) as stream messages.

import { readFileSync } from 'node:fs';
import { encodeDelta, encodeKey } from '../../proto/ts/frameCodec';
import { encodeTopology, type StreamPiece } from '../../proto/ts/topologyCodec';
import { clothFromObj } from '../src/api/objCloth';

export interface Recording {
  topology: Uint8Array;
  frames: { key: Uint8Array; delta: Uint8Array | null; step: number; time: number; speed: number; gap: number }[];
}

const kOrigin: [number, number, number] = [0, 1, 0];
const kStep = 1e-4;

/** Reads `folder`/t.trace, final.obj and rest.obj when there is one. */
export function readRecording(folder: string, colour: [number, number, number]): Recording {
  const bytes = readFileSync(`${folder}/t.trace`);
  const vertexCount = bytes.readUInt32LE(12);
  const triangleCount = bytes.readUInt32LE(16);
  const triangles = Uint32Array.from({ length: 3 * triangleCount }, (_, i) => bytes.readUInt32LE(24 + 4 * i));
  const obj = clothFromObj(readFileSync(`${folder}/final.obj`, 'utf8'), () => colour);
  const { sewn } = obj.topology;
  const topology = encodeTopology({
    epoch: 1,
    origin: kOrigin,
    step: kStep,
    vertexCount,
    triangles,
    sewn,
    rest: flat(bytes, 24 + 12 * triangleCount, vertexCount),
    pieces: obj.topology.pieces.map((piece): StreamPiece => ({ ...piece, colour })),
  });
  const size = 16 + 12 * vertexCount;
  const frames: Recording['frames'] = [];
  let before: Int16Array | null = null;
  let lastTime = 0;
  for (let at = 24 + 12 * triangleCount; at + size <= bytes.length; at += size) {
    const grid = Int16Array.from({ length: 3 * vertexCount }, (_, i) =>
      Math.round((bytes.readFloatLE(at + 16 + 4 * i) - kOrigin[i % 3]!) / kStep),
    );
    const header = { epoch: 1, seq: frames.length + 1, step: bytes.readUInt32LE(at), time: bytes.readDoubleLE(at + 8) };
    frames.push({
      key: encodeKey(header, grid),
      delta: before && encodeDelta(header, grid, before),
      step: header.step,
      time: header.time,
      speed: before ? speedOf(before, grid, header.time - lastTime) : 0,
      gap: gapOf(grid, sewn),
    });
    before = grid;
    lastTime = header.time;
  }
  return { topology, frames };
}

/** The start, unrolled: angle about the axis and height stand in for the flat pattern. */
function flat(bytes: Buffer, at: number, vertexCount: number): Float32Array {
  const rest = new Float32Array(2 * vertexCount);
  for (let v = 0; v < vertexCount; ++v) {
    const [x, y, z] = [0, 4, 8].map((k) => bytes.readFloatLE(at + 16 + 12 * v + k));
    rest[2 * v] = 0.25 * Math.atan2(x!, z!);
    rest[2 * v + 1] = y!;
  }
  return rest;
}

function speedOf(a: Int16Array, b: Int16Array, seconds: number): number {
  let sum = 0;
  for (let i = 0; i < a.length; ++i) sum += (kStep * (b[i]! - a[i]!)) ** 2;
  return Math.sqrt(sum / (a.length / 3)) / Math.max(seconds, 1e-6);
}

/** mm */
function gapOf(grid: Int16Array, sewn: Uint32Array): number {
  let widest = 0;
  for (let i = 0; i < sewn.length; i += 2) {
    const a = 3 * sewn[i]!;
    const b = 3 * sewn[i + 1]!;
    widest = Math.max(
      widest,
      Math.hypot(grid[a]! - grid[b]!, grid[a + 1]! - grid[b + 1]!, grid[a + 2]! - grid[b + 2]!),
    );
  }
  return widest * kStep * 1000;
}
