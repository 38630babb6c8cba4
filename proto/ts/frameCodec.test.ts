import { describe, expect, it } from 'vitest';
import { FrameReader, decodeFrame, dequantise, emptyFrameHeader, encodeDelta, encodeKey } from './frameCodec';
import { goldenFrames, goldenTopologies, refusedFrames, refusedTopologies } from './golden';
import { FrameError, MessageType, messageType } from './message';
import { decodeTopology, encodeTopology } from './topologyCodec';

/** A cloth of so many vertices at moment t: smooth along its order and in time. */
function cloth(vertexCount: number, t: number): Int16Array {
  const wave = (i: number): number => 900 * Math.sin(0.02 * Math.floor(i / 3) + 0.05 * t + (i % 3));
  return Int16Array.from({ length: 3 * vertexCount }, (_, i) => wave(i));
}

const nothing = new Int16Array(0);
const header = (seq: number, epoch = 1) => ({ epoch, seq, step: 50 * seq, time: 0.25 });

function codeOf(act: () => unknown): string {
  try {
    act();
  } catch (error) {
    if (error instanceof FrameError) return error.code;
    throw error;
  }
  return 'no error';
}

describe('frames', () => {
  it('have golden messages of every kind', () => {
    expect(goldenFrames.length).toBeGreaterThanOrEqual(10);
    expect(refusedFrames.length).toBeGreaterThanOrEqual(15);
  });

  it.each(goldenFrames)('are written to the golden bytes of $file', ({ bytes, header: head, before, grid }) => {
    expect(head.key ? encodeKey(head, grid) : encodeDelta(head, grid, before)).toEqual(bytes);
  });

  it.each(goldenFrames)('are read from the golden bytes of $file', ({ bytes, header: head, before, grid }) => {
    expect(decodeFrame(bytes, before)).toEqual({ header: head, grid });
  });

  it.each(refusedFrames)('are refused: $why', ({ bytes, code, before }) => {
    expect(codeOf(() => decodeFrame(bytes, before))).toBe(code);
  });

  it('arrive whole for every number of vertices around the block size', () => {
    for (let n = 0; n <= 50; ++n) {
      expect(decodeFrame(encodeKey(header(1), cloth(n, 7)), nothing).grid).toEqual(cloth(n, 7));
      expect(decodeFrame(encodeDelta(header(2), cloth(n, 7), cloth(n, 0)), cloth(n, 0)).grid).toEqual(cloth(n, 7));
    }
  });

  it('are read at any place of a larger buffer', () => {
    const key = encodeKey(header(1), cloth(40, 0));
    const larger = new Uint8Array(key.length + 3).fill(255);
    larger.set(key, 3);
    expect(decodeFrame(larger.subarray(3), nothing).grid).toEqual(cloth(40, 0));
  });

  it('go into the array that is there, which may be the frame before', () => {
    const frame = { header: emptyFrameHeader(), grid: cloth(40, 0) };
    const grid = frame.grid;
    expect(decodeFrame(encodeDelta(header(2), cloth(40, 1), cloth(40, 0)), grid, frame)).toBe(frame);
    expect(frame.grid).toBe(grid);
    expect(grid).toEqual(cloth(40, 1));
    expect(frame.header.seq).toBe(2);
  });

  it('leave everything as it was when they are refused', () => {
    const frame = { header: emptyFrameHeader(), grid: cloth(40, 0) };
    const bytes = encodeDelta(header(2), cloth(40, 1), cloth(40, 0));
    expect(codeOf(() => decodeFrame(bytes.subarray(0, bytes.length - 1), frame.grid, frame))).toBe('frame.malformed');
    expect(frame).toEqual({ header: emptyFrameHeader(), grid: cloth(40, 0) });
  });

  it('that were changed at random are read or refused, and nothing else', () => {
    let state = 2463534242;
    const below = (limit: number): number => {
      state ^= state << 13;
      state ^= state >>> 17;
      state ^= state << 5;
      return (state >>> 0) % limit;
    };
    const seen = new Set<string>();
    const topologies = goldenTopologies.map(({ bytes }) => ({ bytes, before: nothing }));
    for (const { bytes, before } of [...goldenFrames, ...topologies]) {
      for (let i = 0; i < 500; ++i) {
        const changed = bytes.slice(0, below(4) === 0 ? below(bytes.length) : bytes.length);
        for (let n = below(4); n > 0 && changed.length > 0; --n) changed[below(changed.length)] = below(256);
        const isTopology = changed.length > 3 && changed[3] === MessageType.topology;
        seen.add(codeOf(() => (isTopology ? decodeTopology(changed) : decodeFrame(changed, before))));
      }
    }
    expect([...seen].sort()).toEqual(['frame.malformed', 'frame.version', 'frame.wrong_base', 'no error']);
  });
});

describe('a frame reader', () => {
  it('follows a key and its deltas in one array', () => {
    const reader = new FrameReader(2, 100);
    const grid = reader.grid;
    expect(reader.header).toBeNull();
    reader.read(encodeKey(header(10, 2), cloth(100, 10)));
    for (let t = 11; t < 20; ++t) reader.read(encodeDelta(header(t, 2), cloth(100, t), cloth(100, t - 1)));
    expect(reader.grid).toBe(grid);
    expect(grid).toEqual(cloth(100, 19));
    expect(reader.header).toEqual({ key: false, epoch: 2, seq: 19, step: 950, time: 0.25 });
  });

  it('refuses a delta without its base, keeps what it has, and takes the next key', () => {
    const reader = new FrameReader(1, 20);
    const delta = (seq: number) => encodeDelta(header(seq), cloth(20, seq), cloth(20, seq - 1));
    expect(codeOf(() => reader.read(delta(2)))).toBe('frame.wrong_base');
    reader.read(encodeKey(header(1), cloth(20, 1)));
    expect(codeOf(() => reader.read(delta(3)))).toBe('frame.wrong_base');
    expect(codeOf(() => reader.read(delta(1)))).toBe('frame.wrong_base');
    expect(reader.header?.seq).toBe(1);
    expect(reader.grid).toEqual(cloth(20, 1));
    reader.read(encodeKey(header(9), cloth(20, 9)));
    reader.read(delta(10));
    expect(reader.grid).toEqual(cloth(20, 10));
  });

  it('refuses frames of another epoch and of another garment', () => {
    const reader = new FrameReader(4, 20);
    expect(codeOf(() => reader.read(encodeKey(header(1, 3), cloth(20, 1))))).toBe('frame.wrong_base');
    expect(codeOf(() => reader.read(encodeKey(header(1, 4), cloth(21, 1))))).toBe('frame.malformed');
    expect(reader.header).toBeNull();
  });
});

describe('topologies', () => {
  it('have golden messages', () => {
    expect(goldenTopologies.length).toBeGreaterThanOrEqual(3);
    expect(refusedTopologies.length).toBeGreaterThanOrEqual(20);
  });

  it.each(goldenTopologies)('are written to the golden bytes of $file', ({ bytes, topology }) => {
    expect(encodeTopology(topology)).toEqual(bytes);
  });

  it.each(goldenTopologies)('are read from the golden bytes of $file', ({ bytes, topology }) => {
    expect(decodeTopology(bytes)).toEqual(topology);
  });

  it.each(refusedTopologies)('are refused: $why', ({ bytes, code }) => {
    expect(codeOf(() => decodeTopology(bytes))).toBe(code);
  });
});

describe('the type of a message', () => {
  it('stands in its third byte', () => {
    expect(messageType(encodeKey(header(1), cloth(4, 0)))).toBe(MessageType.key);
    expect(messageType(encodeDelta(header(2), cloth(4, 1), cloth(4, 0)))).toBe(MessageType.delta);
    expect(goldenTopologies.map((t) => messageType(t.bytes))).toContain(MessageType.topology);
    expect(codeOf(() => messageType(Uint8Array.of(0x54, 0x4c, 1)))).toBe('frame.malformed');
  });
});

describe('numbers on the grid', () => {
  it('become metres', () => {
    const out = new Float32Array(6);
    dequantise(Int16Array.of(0, 1, -1, 32767, -32768, 10), { origin: [0.5, 1, -0.25], step: 0.0001 }, out);
    const metres = [0.5, 1.0001, -0.2501, 3.7767, -2.2768, -0.249];
    metres.forEach((metre, i) => expect(out[i]).toBeCloseTo(metre, 6));
  });
});
