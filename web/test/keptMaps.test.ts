import { describe, expect, it, vi } from 'vitest';
import type { ClothTopology } from '../src/api/frames';
import { readMaps, type MapFile } from '../src/api/maps';
import type { Job } from '../src/api/types';
import { MapKeeper } from '../src/commands/MapKeeper';
import { AppState, ready } from '../src/state/AppState';
import { mapOf, valueText } from '../src/state/clothMaps';
import { keptValues, missingInBoth, missingMaps } from '../src/state/keptMaps';
import { jobOf } from './fakes';

const piece = (id: string, firstVertex: number) => ({ id, firstVertex, vertexCount: 2, colour: [1, 1, 1] as [number, number, number] });
const topology: ClothTopology = {
  epoch: 0,
  vertexCount: 4,
  origin: [0, 0, 0],
  step: 1e-4,
  pieces: [piece('a', 0), piece('b', 2)],
  rest: new Float32Array(8),
  triangles: new Uint32Array([0, 1, 2]),
  sewn: new Uint32Array(0),
};
/** Its pieces in another order than the cloth's. */
const file: MapFile = {
  pieces: [{ id: 'b', first_vertex: 0, vertex_count: 2 }, { id: 'a', first_vertex: 2, vertex_count: 2 }],
  maps: [{ map: 'pressure', values: [1, 2, 3, 0.05] }, { map: 'ease', values: [9, 9, 9, 9] }],
};
const ended = jobOf({ id: 'j', state: 'succeeded', results: { 'maps.json': 10, 'final.obj': 10 } });
const draping = jobOf({ id: 'j', state: 'running', results: {} });

describe('maps that a drape has left', () => {
  it('lie on the pieces that they are of', () => {
    expect([...keptValues('pressure', file, topology)!]).toEqual([3, 0.05, 1, 2].map(Math.fround));
    expect(keptValues('curvature', file, topology)).toBeNull();
    expect(keptValues('pressure', { ...file, pieces: file.pieces.slice(1) }, topology)).toBeNull();
    const map = mapOf('pressure', keptValues('pressure', file, topology)!);
    expect([map.end, valueText(map, 0.05)]).toEqual([4, '0.05 kPa']);
  });

  it('are read from their file alone', () => {
    expect(readMaps(JSON.stringify(file))).toEqual(file);
    expect(() => readMaps('[]')).toThrow(RangeError);
    expect(() => readMaps('<html>')).toThrow(SyntaxError);
  });

  it('are missing for a reason', () => {
    expect(missingMaps(ended, false)).toEqual({});
    expect(missingMaps(draping, false)).toEqual({ curvature: 'live', pressure: 'live' });
    expect(missingMaps(draping, true)).toEqual({ room: 'bodyless', curvature: 'live', pressure: 'bodyless' });
    expect(missingMaps({ ...ended, results: { 'final.obj': 10 } }, false)).toEqual({ curvature: 'none', pressure: 'none' });
    expect(missingMaps(null, false)).toEqual({ curvature: 'never', pressure: 'never' });
    expect(missingInBoth(missingMaps(draping, true), missingMaps(ended, true))).toEqual({ room: 'bodyless', pressure: 'bodyless' });
  });
});

describe('the keeper of maps', () => {
  const shown = (job: Job, fetch: (id: string, name: string) => Promise<string>): AppState => {
    const state = new AppState();
    new MapKeeper(state, fetch).start();
    state.route.value = { name: 'job', id: 'j' };
    state.jobs.value = ready([job]);
    state.cloth.setTopology(topology);
    state.cloth.setPositions(new Float32Array(12), { epoch: 0, seq: 1, step: 1, time: 0 });
    return state;
  };

  it('fetches them once, when one is chosen, and only of a drape that has ended', async () => {
    const fetch = vi.fn(async () => JSON.stringify(file));
    const state = shown(draping, fetch);
    state.mapKind.value = 'pressure';
    expect(fetch).not.toHaveBeenCalled();
    state.jobs.value = ready([ended]);
    await vi.waitFor(() => expect(state.clothMap.value?.kind).toBe('pressure'));
    expect(fetch).toHaveBeenCalledWith('j', 'maps.json');
    state.mapKind.value = 'curvature';
    expect(state.clothMap.value).toBeNull();
    state.mapKind.value = 'pressure';
    expect(state.clothMap.value!.values[0]).toBe(3);
    expect(fetch).toHaveBeenCalledTimes(1);
  });

  it('says when they cannot be had', async () => {
    const state = shown(ended, async () => '{}');
    state.mapKind.value = 'pressure';
    await vi.waitFor(() => expect(state.notices.value).toHaveLength(1));
    expect(state.clothMap.value).toBeNull();
  });
});
