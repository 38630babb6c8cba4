// Time to read a frame, on a waving sheet about as large as a garment: `vitest bench` (by hand, never in a test).

import { bench, describe } from 'vitest';
import { FrameReader, dequantise, encodeDelta, encodeKey } from './frameCodec';

const kSide = 64;

const sheet = (t: number): Int16Array =>
  Int16Array.from({ length: 3 * kSide * kSide }, (_, i) => {
    const v = Math.floor(i / 3);
    const x = 100 * (v % kSide);
    const y = 100 * Math.floor(v / kSide);
    return [x, y, 500 * Math.sin(9e-4 * x + 0.083 * t) * Math.cos(7e-4 * y - 0.05 * t)][i % 3]!;
  });

const frames = Array.from({ length: 30 }, (_, t) => sheet(t));
const messages = frames.map((grid, t) => {
  const header = { epoch: 1, seq: t + 1, step: 50 * t, time: t / 60 };
  return t === 0 ? encodeKey(header, grid) : encodeDelta(header, grid, frames[t - 1]!);
});
const reader = new FrameReader(1, kSide * kSide);
const positions = new Float32Array(3 * kSide * kSide);

describe(`30 frames of ${kSide * kSide} vertices`, () => {
  bench('read', () => {
    for (const message of messages) reader.read(message);
  });
  bench('to metres', () => {
    for (const frame of frames) dequantise(frame, { origin: [0, 1, 0], step: 1e-4 }, positions);
  });
});
