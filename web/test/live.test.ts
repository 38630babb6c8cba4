// Hands on the cloth of a drape under way: what they say to the service, and what is made of what it says.

import { PlaneGeometry, Mesh, Raycaster, Vector3 } from 'three';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Commands } from '../src/commands/Commands';
import { LiveCommands } from '../src/commands/LiveCommands';
import { WarmEdits } from '../src/commands/WarmEdits';
import { Watcher } from '../src/commands/Watcher';
import { ApiError } from '../src/api/http';
import { JobStream } from '../src/api/JobStream';
import type { ClothTopology } from '../src/api/frames';
import type { Edit, EditStep, StreamWord } from '../src/api/types';
import { clothPoint, placeOf } from '../src/scene/clothPoint';
import { AppState, ready } from '../src/state/AppState';
import type { ClothPoint } from '../src/state/hands';
import { timeLeft } from '../src/state/timeLeft';
import { fakeApi, FakeClock, FakeSocket, jobOf, progressOf, projectOf } from './fakes';

/** Two triangles over a unit square. */
const topology: ClothTopology = {
  epoch: 3,
  vertexCount: 4,
  origin: [0, 0, 0],
  step: 1e-4,
  rest: new Float32Array(8),
  pieces: [],
  triangles: new Uint32Array([0, 1, 2, 2, 1, 3]),
  sewn: new Uint32Array(),
} as unknown as ClothTopology;
const corners = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]);
const point: ClothPoint = { triangle: 1, shares: [0.5, 0.25, 0.25], at: [0.5, 0.5, 0] };

/** A page on which a drape runs and its cloth is seen. */
function running(): AppState {
  const state = new AppState();
  state.projects.value = ready([projectOf()]);
  state.jobs.value = ready([jobOf({ state: 'running', progress: progressOf() })]);
  state.route.value = { name: 'job', id: 'j_1' };
  state.watched.value = 'j_1';
  state.tab.value = 'drape';
  state.stream.value = { state: 'open' };
  state.cloth.setTopology(topology);
  state.cloth.setPositions(corners.slice(), { epoch: 3, seq: 1, step: 50, time: 0.1 });
  return state;
}

describe('hands on cloth', () => {
  let state: AppState;
  let said: StreamWord[];
  let live: LiveCommands;
  beforeEach(() => {
    vi.useFakeTimers();
    state = running();
    said = [];
    live = new LiveCommands(state, (word) => said.push(word));
  });
  afterEach(() => vi.useRealTimers());

  it('reach cloth that drapes or is paused, and no other', () => {
    expect(state.touchable.value).toBe(true);
    state.putJob(jobOf({ state: 'paused' }));
    state.progress.value = progressOf({ state: 'paused' });
    expect(state.touchable.value).toBe(true);
    state.putJob(jobOf({ state: 'queued' }));
    state.progress.value = progressOf({ state: 'queued', step: 50 });
    expect(state.touchable.value, 'resumed, without a worker yet').toBe(true);
    state.progress.value = progressOf({ state: 'queued', step: 0 });
    expect(state.touchable.value, 'not begun').toBe(false);
    state.progress.value = progressOf({ state: 'queued', step: 50 });
    state.stream.value = { state: 'lost', attempt: 1, retryMs: 250 };
    expect(state.touchable.value).toBe(false);
    state.stream.value = { state: 'open' };
    state.progress.value = progressOf({ phase: 'stills' });
    expect(state.touchable.value).toBe(false);
    state.progress.value = null;
    state.putJob(jobOf({ state: 'succeeded' }));
    expect(state.touchable.value).toBe(false);
  });

  it('tell where they draw some thirty times a second, the newest place last', () => {
    live.hold(point);
    for (let i = 1; i <= 100; ++i) {
      live.draw([i, 0, 0]);
      vi.advanceTimersByTime(5);
    }
    vi.advanceTimersByTime(100);
    const pulls = said.filter((word) => word.type === 'pull');
    expect(pulls[0]).toEqual({ type: 'pull', epoch: 3, triangle: 1, shares: [0.5, 0.25, 0.25], to: [0.5, 0.5, 0] });
    expect(pulls.length).toBeGreaterThan(10);
    expect(pulls.length).toBeLessThan(20); // in half a second
    expect(pulls[pulls.length - 1]!.to).toEqual([100, 0, 0]);
    const before = said.length;
    vi.advanceTimersByTime(1000);
    expect(said.length).toBe(before); // a hand that rests says nothing
    live.letGo();
    live.letGo();
    expect(said.slice(before)).toEqual([{ type: 'let_go' }]);
    expect(state.hands.held.value).toBeNull();
  });

  it('let go of what cannot be touched any more', () => {
    live.hold(point);
    state.progress.value = null;
    state.putJob(jobOf({ state: 'succeeded' }));
    expect(said.map((word) => word.type)).toEqual(['pull', 'let_go']);
    vi.advanceTimersByTime(1000);
    expect(said.length).toBe(2);
  });

  it('pin a point, also the one that they hold, and remove pins', () => {
    live.pin(point);
    live.hold(point);
    live.pinHeld();
    live.pinHeld();
    live.unpin(4);
    const pin = { type: 'pin', epoch: 3, triangle: 1, shares: [0.5, 0.25, 0.25] };
    expect(said).toEqual([pin, expect.objectContaining({ type: 'pull' }), pin, { type: 'let_go' }, { type: 'unpin', pin: 4 }]);
  });

  it('take a tool, and put it away by taking it again or by Escape', () => {
    live.take('pull');
    expect(state.hands.tool.value).toBe('pull');
    live.take('pin');
    expect(state.hands.tool.value).toBe('pin');
    live.take('pin');
    expect(state.hands.tool.value).toBe('look');
    live.take('pull');
    live.hold(point);
    expect(live.putAway()).toBe(true);
    expect([state.hands.tool.value, state.hands.held.value, live.putAway()]).toEqual(['look', null, false]);
  });
});

describe('the point that is touched', () => {
  it('is told by the topology’s triangle and shares of its corners, in the topology’s order', () => {
    const mesh = new Mesh(new PlaneGeometry(1, 1).translate(0.5, 0.5, 0));
    const index = [1, 3, 2, 0, 1, 2]; // as a drawing by materials may have them
    mesh.geometry.setIndex(index);
    mesh.geometry.getAttribute('position').array.set(corners);
    mesh.updateMatrixWorld();
    const ray = new Raycaster(new Vector3(0.9, 0.7, 1), new Vector3(0, 0, -1));
    const found = clothPoint(ray.intersectObject(mesh)[0]!, topology, corners)!;
    expect(found.triangle).toBe(1);
    expect(found.shares[0]).toBeCloseTo(0.1, 6);
    expect(found.shares[1]).toBeCloseTo(0.3, 6);
    expect(found.shares[2]).toBeCloseTo(0.6, 6);
    const place = placeOf(found, topology, corners, new Vector3());
    expect(place.x).toBeCloseTo(0.9, 6);
    expect(place.y).toBeCloseTo(0.7, 6);
  });
});

describe('a job’s stream', () => {
  it('says words while it is open, and none into the void', () => {
    const sockets: FakeSocket[] = [];
    const ignore = (): void => undefined;
    const stream = new JobStream(
      'ws://here',
      (url) => {
        sockets.push(new FakeSocket(url));
        return sockets[sockets.length - 1]!;
      },
      new FakeClock(),
      { connection: ignore, text: ignore, binary: ignore },
    );
    stream.say({ type: 'let_go' });
    stream.open();
    stream.say({ type: 'let_go' });
    sockets[0]!.open();
    stream.say({ type: 'unpin', pin: 2 });
    sockets[0]!.breakOff();
    stream.say({ type: 'let_go' });
    expect(sockets[0]!.sent).toEqual([{ type: 'unpin', pin: 2 }]);
  });
});

describe('an edit while it drapes', () => {
  const step = (edit: Edit['edit'], created_ms = 5000): EditStep =>
    ({ number: 1, created_ms, undone: false, edits: [{ edit }] }) as unknown as EditStep;
  const edited = (...steps: EditStep[]): AppState => {
    const state = running();
    state.projects.value = ready([projectOf({ revision: 2 })]);
    state.editing.history.value = steps;
    return state;
  };

  it('goes on warm where cloth may go on hanging, and is asked about elsewhere', () => {
    expect([running().outdated.value, running().goesOnWarm.value]).toEqual([false, false]);
    const warm = edited(step('set_fabric'), step('move_point'));
    expect([warm.outdated.value, warm.goesOnWarm.value]).toEqual([true, true]);
    warm.progress.value = progressOf({ phase: 'stills' });
    expect([warm.touchable.value, warm.goesOnWarm.value]).toEqual([false, true]);
    warm.progress.value = progressOf({ phase: 'sew' });
    expect(warm.goesOnWarm.value).toBe(false);
    const sewn = edited(step('move_point'), step('reverse_seam'));
    expect([sewn.outdated.value, sewn.goesOnWarm.value]).toEqual([true, false]);
    expect(edited(step('set_fabric', 10)).goesOnWarm.value).toBe(false); // of before the drape: another was undone
  });

  it('makes one job of it, and follows there', async () => {
    const state = edited(step('set_fabric'));
    const order: string[] = [];
    const goOn = vi.fn(fakeApi().goOn);
    const nothing = (): void => undefined;
    const around = { go: nothing, save: nothing, anew: nothing, say: nothing, newKey: () => 'key', follow: (id: string) => void order.push(id) };
    const commands = new Commands(state, fakeApi({ goOn }), around, nothing, nothing);
    await Promise.all([commands.goOn(), commands.goOn()]);
    expect(goOn.mock.calls).toEqual([['j_1', 'key']]);
    expect(order).toEqual(['j_next']);
    expect(state.allJobs.value.map((job) => job.id)).toContain('j_next');
  });

  it('is taken over once no more comes, also where the drape ends meanwhile', () => {
    vi.useFakeTimers();
    const goOn = vi.fn(async () => undefined);
    const state = edited(step('set_fabric'));
    const stop = new WarmEdits(state, goOn).start();
    vi.advanceTimersByTime(400);
    state.projects.value = ready([projectOf({ revision: 3 })]);
    vi.advanceTimersByTime(400);
    expect(goOn).not.toHaveBeenCalled();
    state.progress.value = progressOf({ state: 'succeeded', phase: 'stills' });
    state.putJob(jobOf({ state: 'succeeded' }));
    vi.advanceTimersByTime(100);
    expect(goOn).toHaveBeenCalledTimes(1);
    state.projects.value = ready([projectOf({ revision: 4 })]); // of an end that is seen: whoever looks at it is asked
    vi.advanceTimersByTime(1000);
    expect(goOn).toHaveBeenCalledTimes(1);
    stop();
    vi.useRealTimers();
  });

  it('goes on from the end of a drape that ends while it is asked', async () => {
    const state = edited(step('set_fabric'));
    const ended = new ApiError(409, 'jobs.state', 'it has ended');
    const submit = vi.fn(fakeApi().submit);
    const nothing = (): void => undefined;
    const around = { go: nothing, save: nothing, anew: nothing, say: nothing, newKey: () => 'key', follow: nothing };
    const api = fakeApi({ submit, goOn: () => Promise.reject(ended) });
    await new Commands(state, api, around, nothing, nothing).goOn();
    expect(submit.mock.calls).toEqual([['p_1', 'key', 'j_1']]);
    expect(state.notices.value).toEqual([]);
  });

  it('is followed without losing what is seen, also by who did not make it', () => {
    const state = running();
    const stream = { watch: vi.fn(), leave: vi.fn(), poke: vi.fn() };
    const gone: string[] = [];
    const watcher = new Watcher(state, fakeApi(), stream, () => undefined, (id) => gone.push(id));
    state.body.value = ready({ positions: new Float32Array(), triangles: new Uint32Array() } as never);
    const old = jobOf({ state: 'cancelled', reason_code: 'superseded', reason_where: 'j_next' });
    watcher.handlers().text({ type: 'ended', ...progressOf({ state: 'cancelled' }), job: old } as never);
    expect(gone).toEqual(['j_next']);
    expect(stream.watch).toHaveBeenCalledWith('ws://here/j_next');
    expect(state.watched.value).toBe('j_next');
    expect(state.covered.value).toBe(true);
    expect(state.body.value?.state).toBe('ready');
    watcher.follow('j_next');
    expect(stream.watch).toHaveBeenCalledTimes(1);
  });
});

describe('the time that is left', () => {
  /** Speeds that fall by `rate` a simulated second, every 50 ms until `t`. */
  const falling = (rate: number, t: number) =>
    Array.from({ length: Math.round(t / 0.05) }, (_, i) => ({ t: 0.05 * (i + 1), speed: Math.exp(-rate * 0.05 * (i + 1)) }));
  const now = (t: number, more = {}) =>
    progressOf({ phase: 'drape', step: 3000 * t, simulated_s: t, step_ms: 1, fraction: 0.1, ...more });

  it('goes by how the speed falls', () => {
    // From e^-2 to 0.005 at 2 a second: 1.65 s, and a quarter for the proof; a simulated second takes 3 s.
    expect(timeLeft(now(1), falling(2, 1))).toBeCloseTo(3 * ((Math.log(1 / 0.005) - 2) / 2 + 0.25), 1);
  });

  it('is no longer than until the drape’s time is up', () => {
    expect(timeLeft(now(1, { fraction: 0.5 }), falling(0.1, 1))).toBeLessThan(3.1);
  });

  it('is not told where nothing can be said', () => {
    expect(timeLeft(now(1, { phase: 'sew' }), falling(2, 1))).toBeNull();
    expect(timeLeft(now(1, { pulls: 1 }), falling(2, 1))).toBeNull();
    expect(timeLeft(now(1), falling(-2, 1))).toBeNull(); // it gathers speed
    expect(timeLeft(now(1), falling(2, 0.1))).toBeNull();
    expect(timeLeft(now(1), [])).toBeNull();
    expect(timeLeft(now(1, { step_ms: 0 }), falling(2, 1))).toBeNull();
  });
});
