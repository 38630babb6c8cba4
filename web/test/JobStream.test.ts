import { describe, expect, it } from 'vitest';
import { backoff, isRefusal, JobStream, type StreamConnection } from '../src/api/JobStream';
import { FakeClock, FakeSocket, kept } from './fakes';

function begin() {
  const clock = new FakeClock();
  const sockets: FakeSocket[] = [];
  const connections: StreamConnection[] = [];
  const texts: { type: string }[] = [];
  const binaries: Uint8Array[] = [];
  const stream = new JobStream('ws://here/stream', (url) => kept(sockets, new FakeSocket(url)), clock, {
    connection: (connection) => connections.push(connection),
    text: (message) => texts.push(message),
    binary: (bytes) => binaries.push(bytes),
  });
  stream.open();
  return {
    clock,
    sockets,
    connections,
    texts,
    binaries,
    stream,
    last: () => connections[connections.length - 1]!,
    socket: () => sockets[sockets.length - 1]!,
  };
}

describe('a job’s stream', () => {
  it('hands on text and binary messages', () => {
    const { socket, texts, binaries } = begin();
    socket().open();
    socket().say({ type: 'job', id: 'j_1' });
    socket().say(new Uint8Array([1, 2, 3]));
    expect(texts).toEqual([{ type: 'job', id: 'j_1' }]);
    expect([...binaries[0]!]).toEqual([1, 2, 3]);
  });

  it('comes back by itself after a loss, with growing pauses up to five seconds', () => {
    const { clock, sockets, socket, last } = begin();
    socket().open();
    const pauses: number[] = [];
    for (let i = 0; i < 7; ++i) {
      socket().breakOff();
      const lost = last();
      expect(lost.state).toBe('lost');
      pauses.push((lost as { retryMs: number }).retryMs);
      const before = sockets.length;
      clock.advance(pauses[i]! - 1);
      expect(sockets.length).toBe(before);
      clock.advance(1);
      expect(sockets.length).toBe(before + 1);
    }
    expect(pauses).toEqual([250, 500, 1000, 2000, 4000, 5000, 5000]);
  });

  it('begins again with the shortest pause once a connection has said something', () => {
    const { clock, socket, last } = begin();
    for (let i = 0; i < 4; ++i) {
      socket().breakOff();
      clock.advance(5000);
    }
    socket().open();
    socket().say({ type: 'job' });
    socket().breakOff();
    expect(last()).toMatchObject({ state: 'lost', attempt: 1, retryMs: 250 });
  });

  it('does not take an open that says nothing for a good connection', () => {
    const { clock, socket, last } = begin();
    socket().breakOff();
    clock.advance(250);
    socket().open();
    socket().breakOff();
    expect(last()).toMatchObject({ state: 'lost', attempt: 2 });
  });

  it('stays away after the drape has ended', () => {
    const { clock, sockets, socket, last } = begin();
    socket().open();
    socket().say({ type: 'ended', state: 'succeeded' });
    socket().breakOff(1000);
    expect(last()).toEqual({ state: 'closed' });
    clock.advance(60000);
    expect(sockets.length).toBe(1);
  });

  it('comes back when the server stopped before the drape had ended', () => {
    for (const state of ['queued', 'running', 'paused']) {
      const { clock, sockets, socket } = begin();
      socket().open();
      socket().say({ type: 'ended', state });
      socket().breakOff(1000);
      clock.advance(250);
      expect(sockets.length).toBe(2);
    }
  });

  it('does not knock again where it was refused', () => {
    const { clock, sockets, socket, last } = begin();
    socket().breakOff(1008, 'no such job');
    expect(last()).toEqual({ state: 'refused', code: 1008, reason: 'no such job' });
    clock.advance(60000);
    expect(sockets.length).toBe(1);
    expect([isRefusal(4404), isRefusal(1001), isRefusal(1006)]).toEqual([true, false, false]);
  });

  it('tries at once when poked, and only once', () => {
    const { clock, sockets, socket, stream } = begin();
    socket().breakOff();
    stream.poke();
    expect(sockets.length).toBe(2);
    expect(clock.waiting).toBe(0);
    stream.poke();
    expect(sockets.length).toBe(2);
  });

  it('leaves for good when closed, whatever the old socket still says', () => {
    const { clock, sockets, socket, stream, texts } = begin();
    const old = socket();
    old.open();
    stream.close();
    old.say({ type: 'progress' });
    old.breakOff();
    clock.advance(60000);
    expect(old.closedByUs).toBe(true);
    expect(texts).toEqual([]);
    expect(sockets.length).toBe(1);
  });

  it('drops the socket and asks anew when told to restart', () => {
    const { clock, sockets, socket, stream } = begin();
    socket().open();
    stream.restart();
    expect(sockets[0]!.closedByUs).toBe(true);
    clock.advance(250);
    expect(sockets.length).toBe(2);
  });

  it('passes over text that is no message', () => {
    const { socket, texts } = begin();
    socket().open();
    for (const data of ['', '{', 'null', '[]', '{"type":3}', '"x"']) socket().onmessage?.({ data });
    expect(texts).toEqual([]);
  });
});

describe('the pause before a new try', () => {
  it('varies by a fifth either way, so that viewers do not come back in one instant', () => {
    expect(backoff(1, 0)).toBe(200);
    expect(backoff(1, 1)).toBe(300);
    expect(backoff(100, 0.5)).toBe(5000);
  });
});
