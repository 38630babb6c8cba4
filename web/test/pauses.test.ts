// Viewers through many pauses, from the socket to what the page shows: none may stand still when the drape goes on.

import { afterEach, describe, expect, it, vi } from 'vitest';
import { encodeDelta, encodeKey } from '../../proto/ts/frameCodec';
import { encodeTopology } from '../../proto/ts/topologyCodec';
import { ClothStream, type WorkerPort } from '../src/api/ClothStream';
import type { ClothTopology } from '../src/api/frames';
import type { FromWorker, ToWorker } from '../src/api/messages';
import { StreamReceiver } from '../src/api/StreamReceiver';
import { LiveCloth } from '../src/state/LiveCloth';
import { FakeClock, FakeSocket } from './fakes';

const kVertices = 4;
const topology: ClothTopology = {
  epoch: 1,
  origin: [0, 0, 0],
  step: 1e-4,
  vertexCount: kVertices,
  pieces: [{ id: 'front', firstVertex: 0, vertexCount: kVertices, colour: [1, 0, 0] }],
  rest: new Float32Array(2 * kVertices),
  triangles: new Uint32Array([0, 1, 2]),
  sewn: new Uint32Array(0),
};
const grid = (seq: number): Int16Array => Int16Array.from({ length: 3 * kVertices }, (_, i) => 10 * i + seq);
const header = (seq: number) => ({ epoch: 1, seq, step: 50 * seq, time: seq / 60 });

/** A page and its worker, between which messages wait until they are delivered. */
class Viewer implements WorkerPort {
  onmessage: WorkerPort['onmessage'] = null;
  readonly cloth = new LiveCloth();
  readonly clock = new FakeClock();
  readonly sockets: FakeSocket[] = [];
  private readonly toPage_: FromWorker[] = [];
  private readonly toWorker_: ToWorker[] = [];
  private receiver_: StreamReceiver | null = null;
  private had_ = 0;

  constructor() {
    const { cloth } = this;
    const stream = new ClothStream(this, {
      connection: () => undefined,
      text: () => undefined,
      topology: (one) => cloth.setTopology(one),
      frame: (positions, moment) => cloth.setPositions(positions, moment),
    });
    stream.watch('ws://here');
    this.deliver();
    this.connected();
  }

  postMessage(message: ToWorker): void {
    this.toWorker_.push(message);
  }

  /** As the server sends: the delta to who has the frame before, else a key. */
  send(seq: number): void {
    const socket = this.sockets[this.sockets.length - 1]!;
    const delta = this.had_ > 0 && seq === this.had_ + 1 && seq % 30 !== 1;
    socket.say(delta ? encodeDelta(header(seq), grid(seq), grid(seq - 1)) : encodeKey(header(seq), grid(seq)));
    this.had_ = seq;
  }

  loseConnection(): void {
    this.sockets[this.sockets.length - 1]!.breakOff();
    this.clock.advance(5000);
    this.connected();
  }

  /** All messages that wait, and those that follow from them. */
  deliver(): void {
    while (this.toPage_.length + this.toWorker_.length > 0) {
      for (const message of this.toWorker_.splice(0)) this.work(message);
      for (const data of this.toPage_.splice(0)) this.onmessage!({ data } as MessageEvent<FromWorker>);
    }
  }

  private connected(): void {
    const socket = this.sockets[this.sockets.length - 1]!;
    socket.open();
    socket.say(encodeTopology(topology));
    this.had_ = 0;
  }

  private work(message: ToWorker): void {
    if (message.type === 'buffer') return this.receiver_?.giveBack(message.positions);
    if (message.type !== 'watch') return;
    const { watch } = message;
    const makeSocket = (url: string): FakeSocket => {
      this.sockets.push(new FakeSocket(url));
      return this.sockets[this.sockets.length - 1]!;
    };
    this.receiver_ = new StreamReceiver(message.url, makeSocket, this.clock, {
      connection: (connection) => this.toPage_.push({ type: 'connection', watch, connection }),
      text: (text) => this.toPage_.push({ type: 'text', watch, message: text }),
      topology: (one) => this.toPage_.push({ type: 'topology', watch, topology: one }),
      frame: (positions, moment) => this.toPage_.push({ type: 'frame', watch, positions, moment }),
    });
    this.receiver_.open();
  }
}

/** Lets the drape run and pause again and again; each viewer gets and draws a frame as often as its number says. */
function expectToFollow(viewers: { viewer: Viewer; every: number }[], between: (pause: number) => void): void {
  let seq = 0;
  for (let pause = 1; pause <= 300; ++pause) {
    const until = seq + 1 + ((7 * pause) % 13);
    while (seq < until) {
      ++seq;
      for (const { viewer, every } of viewers) {
        if (seq % every !== 0) continue;
        viewer.send(seq);
        if (seq % (3 * every) === 0) viewer.deliver();
      }
    }
    for (const { viewer, every } of viewers) {
      if (seq % every !== 0) viewer.send(seq); // the newest comes even to the slowest, in the end
      viewer.deliver();
      expect(viewer.cloth.moment?.seq).toBe(seq);
      expect(viewer.cloth.positions![0]).toBeCloseTo(1e-4 * seq, 7);
    }
    between(pause);
  }
}

describe('viewers of a drape that is paused and resumed', () => {
  afterEach(() => vi.unstubAllGlobals());

  it('all follow it, the quick and the slow', () => {
    const viewers = [1, 2, 5, 40].map((every) => ({ viewer: new Viewer(), every }));
    expectToFollow(viewers, () => undefined);
  });

  it('follow it over lost connections', () => {
    const viewers = [1, 7].map((every) => ({ viewer: new Viewer(), every }));
    expectToFollow(viewers, (pause) => {
      if (pause % 3 === 0) viewers[pause % 2]!.viewer.loseConnection();
    });
  });

  it('follow it although one of the views breaks at every frame', () => {
    const broken: unknown[] = [];
    vi.stubGlobal('reportError', (error: unknown) => broken.push(error));
    const viewer = new Viewer();
    viewer.cloth.listen(() => {
      throw new Error('this view cannot draw it');
    });
    let drawn = 0;
    viewer.cloth.listen((event) => (drawn += event === 'frame' ? 1 : 0));
    expectToFollow([{ viewer, every: 1 }], () => undefined);
    expect(drawn).toBeGreaterThan(300);
    expect(broken.length).toBeGreaterThan(300);
  });
});
