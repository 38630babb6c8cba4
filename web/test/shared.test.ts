import { describe, expect, it, vi } from 'vitest';
import { ApiError } from '../src/api/http';
import type { SharedApi } from '../src/api/links';
import type { SharedJob } from '../src/api/types';
import { clothFromObj } from '../src/api/objCloth';
import { SharedKeeper } from '../src/commands/SharedKeeper';
import { AppState, valueOf } from '../src/state/AppState';
import { parseRoute, formatRoute } from '../src/state/routes';
import { closedBy, goodUntil, SharedState, takenHome } from '../src/state/shared';
import { jobOf } from './fakes';
import { sharedOf } from './sharedJob';

const kTriangle = 'o front\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n';
const later = (): Promise<void> => new Promise((done) => setTimeout(done));

function apiOf(more: Partial<SharedApi> = {}): SharedApi {
  return {
    open: async () => sharedOf(),
    show: async () => sharedOf(),
    cloth: async () => kTriangle,
    body: async () => ({ positions: new Float32Array(9), indices: new Uint32Array(3) }),
    pieces: async () => ({
      pieces: [
        {
          id: 'front', fabric: 'denim', colour: [1, 0, 0], grain: [0, 1], outline: [], holes: [], edges: [], notches: [], lines: [],
          texture: { image: 'checks.png', scale_mm: 40, offset: [0, 0], angle: 0 },
        },
      ],
      fabrics: [],
    }),
    pictureUrl: (id, name) => `${id}/pictures/${name}`,
    stillUrl: (id, name, width) => `${id}/${name}?${width}`,
    fileUrl: (id, name) => `${id}/${name}`,
    reportUrl: (id) => `${id}/report`,
    streamUrl: (id) => `ws://here/${id}`,
    ...more,
  };
}

function keeperOf(api: SharedApi) {
  const state = new AppState();
  const shared = new SharedState();
  const stream = { watch: vi.fn(), leave: vi.fn() };
  const load = vi.fn(async (url: string) => ({ url, width: 1, height: 1, image: {} as CanvasImageSource }));
  return { state, shared, stream, load, keeper: new SharedKeeper(state, shared, api, stream, load) };
}

const failing = (code: string, status = 410) => () => Promise.reject(new ApiError(status, code, 'It is over.'));

describe('a share link', () => {
  it('has an address of its own, whose secret no server is sent', () => {
    const route = parseRoute('#/shared/toile_0123abc');
    expect(route).toEqual({ name: 'shared', secret: 'toile_0123abc' });
    expect(formatRoute(route)).toBe('#/shared/toile_0123abc');
    expect(parseRoute('#/shared/../jobs').name).toBe('unknown');
  });

  it('shows a drape that has ended, in its colours and with its prints', async () => {
    const { state, stream, load, keeper } = keeperOf(apiOf());
    await keeper.open('secret');
    expect(stream.watch).not.toHaveBeenCalled();
    expect(state.cloth.topology?.pieces[0]).toMatchObject({ id: 'front', colour: [1, 0, 0] });
    expect(state.shownBody.value).not.toBeNull();
    expect(load).toHaveBeenCalledWith('l_1/pictures/checks.png');
    expect([...state.looks.value.keys()]).toEqual(['front']);
    expect(state.since.value).toBeNull();
    // What is measured here can be shown; nobody who looks on could do anything about the rest.
    expect(state.missingMaps.value).toEqual({ curvature: 'never', pressure: 'never' });
  });

  it('shows a live one as it moves, and fetches what it came to', async () => {
    const live = sharedOf({ state: 'running', cloth: false, results: {}, stills: [], report: null });
    const { state, shared, stream, keeper } = keeperOf(apiOf({ open: async () => live }));
    await keeper.open('secret');
    expect(stream.watch).toHaveBeenCalledExactlyOnceWith('ws://here/l_1');
    expect(state.cloth.topology).toBeNull();
    keeper.handlers().text({ type: 'ended', ...progressOf(), job: jobOf({ id: 'l_1', state: 'succeeded' }) });
    await later();
    expect(valueOf(shared.job.value)?.state).toBe('succeeded');
    expect(state.cloth.topology).not.toBeNull();
  });

  it('asks for the body again that a busy server did not give', async () => {
    const live = sharedOf({ state: 'running', cloth: false });
    const body = vi.fn(async () => ({ positions: new Float32Array(9), indices: new Uint32Array(3) }));
    const { state, keeper } = keeperOf(apiOf({ open: async () => live, body: body.mockRejectedValueOnce(new ApiError(503, 'server.busy', '')) }));
    await keeper.open('secret');
    expect(state.body.value?.state).toBe('failed');
    keeper.handlers().topology(clothFromObj(kTriangle, []).topology);
    await later();
    expect(state.body.value?.state).toBe('ready');
  });

  it.each(['links.expired', 'links.revoked', 'links.removed'])('says when it is over: %s', async (code) => {
    const { shared, keeper } = keeperOf(apiOf({ open: failing(code) }));
    await keeper.open('secret');
    const now = shared.job.value;
    expect(now.state).toBe('failed');
    if (now.state !== 'failed') return;
    expect(closedBy(now.error).again).toBe(false);
    expect(closedBy(now.error).title).not.toBe(closedBy(new ApiError(422, 'other', '')).title);
  });

  it('is over for who looks on when it is taken back', async () => {
    const live = sharedOf({ state: 'running', cloth: false });
    const { shared, stream, keeper } = keeperOf(apiOf({ open: async () => live, show: failing('links.revoked') }));
    await keeper.open('secret');
    keeper.handlers().connection({ state: 'refused', code: 1008, reason: 'links.over' });
    await later();
    expect(shared.job.value.state).toBe('failed');
    expect(stream.leave).toHaveBeenCalled();
  });

  it('goes on showing what it had while the server does not answer', async () => {
    const { shared, keeper } = keeperOf(apiOf({ show: failing('net.unreachable', 0) }));
    await keeper.open('secret');
    keeper.handlers().connection({ state: 'lost', attempt: 2, retryMs: 500 });
    await later();
    expect(shared.job.value.state).toBe('ready');
  });

  it('offers what its owner allows and no more', () => {
    expect(takenHome(sharedOf({ results: { 'final.glb': 7 } })).map(({ name }) => name)).toEqual(['final.glb']);
    expect(takenHome(sharedOf({ results: {} }))).toEqual([]);
  });

  it('says how long it is good', () => {
    expect(goodUntil(0)).toContain('does not expire');
    expect(goodUntil(Date.UTC(2027, 2, 3, 12))).toContain('3 March 2027');
  });
});

const progressOf = (): NonNullable<SharedJob['progress']> => ({
  state: 'succeeded', phase: 'stills', fraction: 1, step: 1, simulated_s: 1, rms_speed: 0, seam_gap_mm: 0, cloth_body: 0, cloth_cloth: 0, step_ms: 1, pulls: 0, pins: [],
});
