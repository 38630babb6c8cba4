import { describe, expect, it } from 'vitest';
import { encodeDelta, encodeKey } from '../../proto/ts/frameCodec';
import { encodeTopology } from '../../proto/ts/topologyCodec';
import type { ClothTopology } from '../src/api/frames';
import { FrameSlot, type Moment } from '../src/api/FrameSlot';
import { StreamReceiver } from '../src/api/StreamReceiver';
import { FakeClock, FakeSocket, kept } from './fakes';

const topology: ClothTopology = {
  epoch: 1,
  origin: [0, 1, 0],
  step: 1e-4,
  vertexCount: 3,
  pieces: [{ id: 'front', firstVertex: 0, vertexCount: 3, colour: [1, 0, 0] }],
  rest: new Float32Array(6),
  triangles: new Uint32Array([0, 1, 2]),
  sewn: new Uint32Array([0, 2]),
};
const grid = (n: number): Int16Array => Int16Array.from({ length: 9 }, (_, i) => 100 * i + n);
const header = (seq: number) => ({ epoch: 1, seq, step: 50 * seq, time: seq / 60 });

function begin() {
  const clock = new FakeClock();
  const sockets: FakeSocket[] = [];
  const frames: { positions: Float32Array<ArrayBuffer>; moment: Moment }[] = [];
  const topologies: ClothTopology[] = [];
  const receiver = new StreamReceiver('ws://here', (url) => kept(sockets, new FakeSocket(url)), clock, {
    connection: () => undefined,
    text: () => undefined,
    topology: (one) => topologies.push(one),
    frame: (positions, moment) => frames.push({ positions, moment }),
  });
  receiver.open();
  sockets[0]!.open();
  return { clock, sockets, frames, topologies, receiver, socket: () => sockets[sockets.length - 1]! };
}

describe('the receiver of a stream', () => {
  it('decodes a key and the deltas after it to metres', () => {
    const { socket, frames, receiver } = begin();
    socket().say(encodeTopology(topology));
    socket().say(encodeKey(header(1), grid(0)));
    socket().say(encodeDelta(header(2), grid(7), grid(0)));
    expect(frames.map((frame) => frame.moment.seq)).toEqual([1, 2]);
    expect(frames[1]!.positions[1]).toBeCloseTo(1 + 1e-4 * 107, 6);
    receiver.close();
  });

  it('gives the newest frame and none between to a page that is slow to return its buffers', () => {
    const { socket, frames, receiver } = begin();
    socket().say(encodeTopology(topology));
    socket().say(encodeKey(header(1), grid(1)));
    for (let seq = 2; seq <= 9; ++seq) socket().say(encodeDelta(header(seq), grid(seq), grid(seq - 1)));
    expect(frames.map((frame) => frame.moment.seq)).toEqual([1, 2]);
    receiver.giveBack(frames[0]!.positions);
    expect(frames.map((frame) => frame.moment.seq)).toEqual([1, 2, 9]);
    expect(frames[2]!.positions).toBe(frames[0]!.positions);
    expect(frames[2]!.positions[0]).toBeCloseTo(9e-4, 7);
  });

  it('asks for a key by a new connection when a delta does not fit', () => {
    const { clock, sockets, socket, frames } = begin();
    socket().say(encodeTopology(topology));
    socket().say(encodeKey(header(1), grid(0)));
    socket().say(encodeDelta(header(4), grid(7), grid(0)));
    expect(sockets[0]!.closedByUs).toBe(true);
    clock.advance(250);
    socket().open();
    socket().say(encodeTopology(topology));
    socket().say(encodeKey(header(5), grid(5)));
    expect(frames.map((frame) => frame.moment.seq)).toEqual([1, 5]);
  });

  it('does the same for bytes that are no message, and for a frame before its topology', () => {
    for (const bytes of [new Uint8Array([1, 2, 3]), encodeKey(header(1), grid(0))]) {
      const { sockets, socket, frames } = begin();
      socket().say(bytes);
      expect(sockets[0]!.closedByUs).toBe(true);
      expect(frames).toEqual([]);
    }
  });

  it('takes a new epoch with another number of vertices', () => {
    const { socket, frames, topologies, receiver } = begin();
    socket().say(encodeTopology(topology));
    socket().say(encodeKey(header(1), grid(0)));
    const larger = { ...topology, epoch: 2, vertexCount: 4, rest: new Float32Array(8) };
    socket().say(encodeTopology(larger));
    receiver.giveBack(frames[0]!.positions);
    socket().say(encodeKey({ ...header(1), epoch: 2 }, new Int16Array(12)));
    expect(topologies.length).toBe(2);
    expect(frames[1]!.positions.length).toBe(12);
  });
});

describe('a frame slot', () => {
  it('makes two buffers and never a third', () => {
    const shown: Float32Array<ArrayBuffer>[] = [];
    const slot = new FrameSlot(3, topology, (positions) => shown.push(positions));
    for (let i = 0; i < 20; ++i) {
      slot.put(new Int16Array(3), header(i));
      if (shown.length > 1) slot.giveBack(shown[shown.length - 2]!);
    }
    expect(shown.length).toBe(20);
    expect(new Set(shown).size).toBe(2);
  });
});
