import { describe, expect, it, vi } from 'vitest';
import { ApiError } from '../src/api/http';
import type { Job } from '../src/api/types';
import { Comparer } from '../src/commands/Comparer';
import { AppState } from '../src/state/AppState';
import { apart, comparable, comparedOf, comparisonRows, type ComparedDrape } from '../src/state/comparison';
import { ofOneScale, mapOf } from '../src/state/clothMaps';
import { formatRoute, parseRoute } from '../src/state/routes';
import { jobOf, projectOf, seenOf } from './fakes';
import { fabricOf, reportOf } from './samples';

const ended = (id: string, more: Partial<Job> = {}): Job =>
  jobOf({ id, state: 'succeeded', results: { 'final.obj': 9, 'report.json': 9 }, ...more });

const kSquare = 'o front\nv 0 1 0\nv 1 1 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n';

const drape = (y: number, more: Partial<ComparedDrape> = {}): ComparedDrape => ({
  job: ended('j_1'),
  topology: {
    epoch: 0,
    vertexCount: 2,
    origin: [0, 0, 0],
    step: 1e-4,
    pieces: [{ id: 'front', firstVertex: 0, vertexCount: 2, colour: [1, 1, 1] }],
    rest: new Float32Array([0, 0, 1, 0]),
    triangles: new Uint32Array(0),
    sewn: new Uint32Array(0),
  },
  positions: new Float32Array([0, y, 0, 1, y, 0]),
  body: null,
  pieces: [],
  looks: new Map(),
  finishes: new Map(),
  report: null,
  ...more,
});

describe('drapes to compare', () => {
  it('have cloth to show; those of the same project come first, the newest first', () => {
    const jobs = [
      ended('old', { created_ms: 1 }),
      ended('other', { created_ms: 9, project_id: 'p_2' }),
      ended('new', { created_ms: 5 }),
      ended('failed', { results: {} }),
      ended('this', { created_ms: 7 }),
    ];
    expect(comparable(jobs, jobs[4]!).map(({ id }) => id)).toEqual(['new', 'old', 'other']);
    expect(comparable(jobs, jobs[3]!)).toEqual([]);
  });

  it('stand at an address of their own', () => {
    const route = { name: 'compare', left: 'j_1', right: 'j_2' } as const;
    expect(formatRoute(route)).toBe('#/compare/j_1/j_2');
    expect(parseRoute('#/compare/j_1/j_2')).toEqual(route);
    expect(parseRoute('#/compare/j_1').name).toBe('unknown');
  });

  it('are told how far apart their vertices lie, where they are of one mesh', () => {
    expect(apart(drape(1), drape(1.01))).toBeCloseTo(10, 3);
    const finer = drape(1);
    expect(apart(drape(1), { ...finer, topology: { ...finer.topology, vertexCount: 3 } })).toBeNull();
    expect(apart(drape(1), { ...finer, topology: { ...finer.topology, rest: new Float32Array([0, 0, 2, 0]) } })).toBeNull();
  });

  it('have all figures side by side, what differs marked', () => {
    const rows = comparisonRows(reportOf(), reportOf({ particles: 4000 }), 'cm');
    expect(rows.find(({ title }) => title === 'Particles')).toEqual({ title: 'Particles', left: '3,286', right: '4,000', differs: true });
    expect(rows.filter(({ differs }) => differs)).toHaveLength(1);
    expect(comparisonRows(null, reportOf(), 'cm')[0]).toMatchObject({ left: '–', right: 'settled' });
  });

  it('share the wider scale of their maps', () => {
    const [slack, tight] = [mapOf('warp', new Float32Array([0.5])), mapOf('warp', new Float32Array([7]))];
    expect(ofOneScale([slack, null, tight]).map((map) => map?.end)).toEqual([8, undefined, 8]);
  });
});

describe('the comparer', () => {
  const settle = async (): Promise<void> => {
    for (let i = 0; i < 10; ++i) await Promise.resolve();
  };
  const serviceOf = (broken: string[] = []) => ({
    asked: [] as string[],
    job(id: string) {
      this.asked.push(id);
      return broken.includes(id) ? Promise.reject(new ApiError(404, 'job.unknown', 'no such job')) : Promise.resolve(ended(id));
    },
    resultText: () => Promise.resolve(kSquare),
    report: () => Promise.resolve(reportOf()),
    seenPieces: () => Promise.resolve({ pieces: [seenOf('front', { colour: [0, 1, 0] })], fabrics: [] }),
    body: () => Promise.reject(new ApiError(404, 'job.no_body', 'it hung free')),
    project: () => Promise.resolve(projectOf({ files: { 'dots.png': 'as_1', 'lost.png': 'as_2' } })),
    assetUrl: (id: string) => `/assets/${id}`,
  });

  it('fetches both as the address names them, and lets go when it names none', async () => {
    const state = new AppState();
    const service = serviceOf();
    const comparer = new Comparer(state, service);
    comparer.start();
    expect(state.comparison.left.value).toBeNull();
    state.route.value = { name: 'compare', left: 'j_1', right: 'j_2' };
    expect(state.comparison.left.value?.state).toBe('loading');
    await settle();
    expect(comparedOf(state.comparison.left.value)?.topology.vertexCount).toBe(3);
    expect(comparedOf(state.comparison.left.value)?.topology.pieces[0]?.colour).toEqual([0, 1, 0]); // as it was draped
    expect(comparedOf(state.comparison.right.value)?.job.id).toBe('j_2');
    state.route.value = { name: 'compare', left: 'j_1', right: 'j_3' };
    await settle();
    expect(service.asked).toEqual(['j_1', 'j_2', 'j_3']);
    state.route.value = { name: 'home' };
    expect(state.comparison.left.value).toBeNull();
    comparer.stop();
  });

  it('shows each with the pictures and the cloth that it was draped with', async () => {
    const state = new AppState();
    const printed = (id: string, image: string) => seenOf(id, { texture: { image, scale_mm: 80, offset: [0, 0], angle: 0 } });
    const seen = (id: string) => ({ pieces: id === 'j_1' ? [printed('front', 'dots.png'), printed('back', 'lost.png')] : [seenOf('front')], fabrics: [fabricOf('f')] });
    const service = { ...serviceOf(), seenPieces: (id: string) => Promise.resolve(seen(id)) };
    const load = async (url: string) => {
      if (url.endsWith('as_2')) throw new Error('it is gone');
      return { url, width: 2, height: 1, image: {} as CanvasImageSource };
    };
    const comparer = new Comparer(state, service, load);
    comparer.start();
    state.route.value = { name: 'compare', left: 'j_1', right: 'j_2' };
    await vi.waitFor(() => expect(comparedOf(state.comparison.left.value)).not.toBeNull());
    const [left, right] = [state.comparison.left, state.comparison.right].map((side) => comparedOf(side.value)!);
    expect([...left!.looks].map(([piece, look]) => [piece, look.picture.url])).toEqual([['front', '/assets/as_1']]);
    expect([...left!.finishes.keys()]).toEqual(['front', 'back']);
    expect(right!.looks.size).toBe(0);
    comparer.stop();
  });

  it('says which of them cannot be had', async () => {
    const state = new AppState();
    const comparer = new Comparer(state, serviceOf(['j_2']));
    comparer.start();
    state.route.value = { name: 'compare', left: 'j_1', right: 'j_2' };
    await settle();
    expect(comparedOf(state.comparison.left.value)).not.toBeNull();
    const right = state.comparison.right.value;
    expect(right?.state === 'failed' && right.error.code).toBe('job.unknown');
    comparer.stop();
  });
});
