import { describe, expect, it, vi } from 'vitest';
import {
  decodeStart,
  makeDressingApi,
  type Check,
  type DressingApi,
  type Finding,
  type PieceWish,
  type Place,
  type ProjectBody,
} from '../src/api/dressing';
import { ApiError, Http } from '../src/api/http';
import { DressingCommands, type Queue } from '../src/commands/DressingCommands';
import { segmentsOf } from '../src/scene/BodyMarks';
import { faceOf, onFace } from '../src/scene/boxFaces';
import { closeUp, type Bounds, type Pose } from '../src/scene/framing';
import type { Project } from '../src/api/types';
import { AppState, ready } from '../src/state/AppState';
import {
  aboutText,
  findingCounts,
  freeBodyId,
  isOwn,
  measureTitle,
  nearestPreset,
  pieceOf,
  presetGroups,
  presetTitle,
  sliderWay,
  sortedFindings,
  withMeasure,
  withoutMeasure,
  withPreset,
} from '../src/state/dressing';
import { assetOf, jobOf, projectOf, seamOf, squareOf } from './fakes';
import type { BoxPlace } from '../src/tools/SceneTool';
import { bodyOf, figure, findingOf, importOf } from './samples';
import { centimetres, lengthWords, shownLength } from '../src/texts/units';

describe('lengths', () => {
  it('are the same in both units', () => {
    expect(shownLength(76.2, 'inch')).toBeCloseTo(30);
    expect(centimetres(30, 'inch')).toBeCloseTo(76.2);
    expect(centimetres(shownLength(71.3, 'inch'), 'inch')).toBeCloseTo(71.3);
    expect(lengthWords(76.2, 'inch')).toBe('30.00 in');
    expect(lengthWords(76.2, 'cm')).toBe('76.2 cm');
    expect(measureTitle('shoulder_width')).toBe('Shoulder width');
  });
});

describe('a mannequin', () => {
  const tables = [
    { name: 'eu38', sex: 'female' as const, measures_cm: { height: 168, bust: 88, waist: 72, hip: 96 } },
    { name: 'eu44', sex: 'female' as const, measures_cm: { height: 168, bust: 100, waist: 84, hip: 108 } },
    { name: 'm50', sex: 'male' as const, measures_cm: { height: 177, bust: 100, waist: 88, hip: 101 } },
  ];

  it('takes a preset in place of its measures and keeps pose and fineness', () => {
    const own = withMeasure({ pose: 't', triangles: 2000, waist_cm: 60 }, 'hip', 98.04);
    expect(own).toEqual({ pose: 't', triangles: 2000, waist_cm: 60, hip_cm: 98 });
    expect(withPreset(own, 'm50')).toEqual({ preset: 'm50', pose: 't', triangles: 2000 });
    expect(withPreset(null, 'eu38')).toEqual({ preset: 'eu38' });
  });

  it('gives a measure back to the table', () => {
    const own = withMeasure({ preset: 'eu38' }, 'waist', 70);
    expect(isOwn(own, 'waist')).toBe(true);
    expect(withoutMeasure(own, 'waist')).toEqual({ preset: 'eu38' });
  });

  it('has its sliders laid around the nearest size of its sex', () => {
    const taken = [{ ...figure.measures[0]!, name: 'waist' as const, cm: 83 }];
    expect(nearestPreset(tables, {}, taken)?.name).toBe('eu44');
    expect(nearestPreset(tables, { sex: 'male' }, taken)?.name).toBe('m50');
    expect(nearestPreset(tables, { preset: 'eu38' }, taken)?.name).toBe('eu38');
    const rule = { name: 'waist' as const, rule: '', girth: true, least_cm: 30, most_cm: 250 };
    expect(sliderWay(rule, 72, 72)).toEqual({ least: 57, most: 96 });
    expect(sliderWay(rule, 72, 120)).toEqual({ least: 57, most: 120 });
    expect(sliderWay({ ...rule, least_cm: 60 }, 72, 72).least).toBe(60);
  });

  it('is listed by sex under names that shops use', () => {
    expect(presetGroups(tables).map((group) => [group.title, group.presets.length])).toEqual([
      ['Women', 2],
      ['Men', 1],
    ]);
    expect(['eu38', 'm50', 'child116'].map(presetTitle)).toEqual(['EU 38', 'Men 50', 'Child 116']);
  });
});

describe('findings', () => {
  it('begin with what keeps the drape from beginning and end with what is repaired', () => {
    const all = [
      findingOf({ repaired: true, severity: 'error', where: 'a' }),
      findingOf({ severity: 'note', where: 'b' }),
      findingOf({ severity: 'error', where: 'c' }),
      findingOf({ where: 'd' }),
    ];
    expect(sortedFindings(all).map((one) => one.where)).toEqual(['c', 'd', 'b', 'a']);
    expect(findingCounts(all)).toEqual({ error: 1, warning: 1, note: 1, repaired: 1 });
  });

  it('name a piece only where there is one', () => {
    expect(pieceOf(findingOf(), ['front', 'back'])).toBe('front');
    const about = (...concerns: ['piece' | 'edge' | 'seam' | 'body', string][]): Finding =>
      findingOf({ about: concerns.map(([thing, id]) => ({ thing, id })) });
    expect(pieceOf(about(['piece', 'front, left'], ['edge', 'e3']), ['front, left'])).toBe('front, left');
    expect(pieceOf(about(['piece', 'back'], ['piece', 'front']), ['front', 'back'])).toBe('back');
    expect(pieceOf(about(['seam', 'front']), ['front'])).toBeNull();
    expect(pieceOf(about(['piece', 'sleeve']), ['front'])).toBeNull();
  });

  it('call seams and edges as the pattern does', () => {
    const sewn = { pieces: [squareOf('front', 0, 0, 100), squareOf('back', 200, 0, 100)], seams: [seamOf('seam1', ['front', 'e1'], ['back', 'e3'])] };
    const about: Finding['about'] = [
      { thing: 'seam', id: 'seam1' },
      { thing: 'piece', id: 'back' },
      { thing: 'edge', id: 'e2' },
      { thing: 'body', id: 'body' },
    ];
    expect(aboutText(findingOf({ about }), sewn)).toBe('seam 1 front to back, piece back, edge top');
  });

  it('are looked at from outside of the body', () => {
    const around: Bounds = { low: [-0.5, 0, -0.2], high: [0.5, 1.7, 0.2] };
    const now: Pose = { eye: [0, 1, 3], target: [0, 1, 0] };
    const back = closeUp([0.05, 1, -0.15], around, now);
    expect(back.target).toEqual([0.05, 1, -0.15]);
    expect(back.eye[2]).toBeLessThan(-0.5);
    expect(closeUp([0, 1.6, 0], around, now).eye[2]).toBeGreaterThan(0.5);
  });
});

it('a tape closes by itself around a girth and not along a length', () => {
  const line: [number, number, number][] = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
  ];
  expect(segmentsOf(line, false).length).toBe(2 * 6);
  expect(segmentsOf(line, true).slice(-6)).toEqual([1, 1, 0, 0, 0, 0]);
  expect(segmentsOf([], true)).toEqual([]);
});

describe('the start', () => {
  it('is refused when its lengths do not agree', () => {
    expect(() => decodeStart(new ArrayBuffer(2))).toThrow(/damaged/);
    const bytes = new ArrayBuffer(8);
    new DataView(bytes).setUint32(0, 900, true);
    expect(() => decodeStart(bytes)).toThrow(/damaged/);
  });
});

describe('the service', () => {
  it('is asked with the revision that a change is for', async () => {
    const asked: [string, RequestInit | undefined][] = [];
    const http = new Http('/api/v1', async (path, init) => {
      asked.push([path, init]);
      return new Response(JSON.stringify(projectOf({ revision: 4 })));
    });
    const api = makeDressingApi(http);
    await api.dress(projectOf({ revision: 3 }), 'my body', { mannequin: { preset: 'eu38' } });
    await api.place(projectOf({ revision: 4 }), {
      piece: 'front',
      part: 'hips',
      side: 'back',
      at_mm: [0, 10],
      away_mm: 50,
      turn: 0,
      wrapped: false,
      flipped: false,
    });
    expect(asked[0]![0]).toBe('/api/v1/projects/p_1/bodies/my%20body');
    expect(asked[0]![1]).toMatchObject({ method: 'PUT', body: '{"mannequin":{"preset":"eu38"}}' });
    expect(new Headers(asked[0]![1]!.headers).get('If-Match')).toBe('"3"');
    expect(new Headers(asked[1]![1]!.headers).get('If-Match')).toBe('"4"');
  });
});

function begin(more: Partial<DressingApi> = {}) {
  const state = new AppState();
  state.projects.value = ready([projectOf()]);
  state.jobs.value = ready([]);
  state.route.value = { name: 'project', id: 'p_1' };
  const missing = (): Promise<never> => Promise.reject(new ApiError(404, 'store.not_found', 'Not there.'));
  const check: Check = { ready: true, findings: [findingOf()], pieces: [] };
  const api: DressingApi = {
    tables: async () => ({ presets: [], measures: [], formats: [] }),
    bodies: async () => [bodyOf()],
    mesh: async () => ({ positions: new Float32Array(3), indices: new Uint32Array(0) }),
    stance: async () => ({ ...figure, stance: null }),
    dress: async (project) => ({ ...project, revision: project.revision + 1 }),
    undress: missing,
    mark: missing,
    unmark: missing,
    arrange: missing,
    place: missing,
    check: async () => check,
    start: missing,
    upload: async (name) => assetOf({ name }),
    ...more,
  };
  const taken: number[] = [];
  const queue: Queue = async (ask) => {
    taken.push((await ask(state.project.value!)).revision);
  };
  return { state, api, commands: new DressingCommands(state, api, queue), taken };
}

describe('dressing', () => {
  it('sends the whole mannequin with the one measure changed', async () => {
    const dress = vi.fn(async (project: Project) => ({ ...project, revision: 2 }));
    const { state, commands, taken } = begin({ dress });
    state.dressing.bodies.value = [bodyOf()];
    await commands.setMeasure('waist', 70);
    expect(dress.mock.calls[0]!.slice(1)).toEqual([
      'anna',
      { mannequin: { preset: 'eu38', triangles: 2000, waist_cm: 70 } },
    ]);
    expect(taken).toEqual([2]);
    expect(state.dressing.busy.value).toBe('');
  });

  it('keeps a refusal beside the sliders and the project as it was', async () => {
    const refuse = (): Promise<never> =>
      Promise.reject(new ApiError(422, 'mannequin.measures', 'These do not go together.', '/mannequin: waist'));
    const { state, commands, taken } = begin({ dress: refuse });
    state.dressing.bodies.value = [bodyOf()];
    await commands.setMeasure('waist', 40);
    expect(state.dressing.problem.value).toMatchObject({ code: 'mannequin.measures' });
    expect(state.notices.value).toEqual([]);
    expect(taken).toEqual([1]);
  });

  it('moves a landmark of the body that has it, and lets one be picked', async () => {
    const mark = vi.fn(async (project: Project) => project);
    const { state, commands } = begin({ mark });
    const navel = { name: 'navel', place: [0, 1, 0.1] as Place };
    state.dressing.bodies.value = [bodyOf(), bodyOf({ id: 'bea', landmarks: [navel] })];
    await commands.mark('navel', [0, 1.1, 0.1]);
    expect(mark.mock.calls[0]!.slice(1)).toEqual(['bea', 'navel', [0, 1.1, 0.1]]);
    commands.pick('  mole ');
    expect(state.dressing.picking.value).toBe('mole');
    expect(state.dressing.marks.value.landmarks).toBe(true);
    await commands.mark('mole', [0, 1.2, 0.1]);
    expect(mark.mock.calls[1]!.slice(1)).toEqual(['anna', 'mole', [0, 1.2, 0.1]]);
    expect(state.dressing.picking.value).toBeNull();
  });

  it('takes the mirror image along unless that is switched off', async () => {
    const place = vi.fn<DressingApi['place']>(async (project) => project);
    const { state, commands } = begin({ place });
    const at: PieceWish = {
      piece: 'sleeve',
      part: 'left_arm',
      side: 'front',
      at_mm: [0, 0],
      away_mm: 50,
      turn: 0,
      wrapped: false,
      flipped: false,
    };
    await commands.place(at);
    state.dressing.partners.value = false;
    await commands.place(at);
    expect(place.mock.calls.map((call) => call[1].with_partner)).toEqual([true, false]);
  });

  it('shows all pieces again when they stood arranged already', async () => {
    const arrange = vi.fn(async (project: Project) => ({ ...project, document: importOf().document!, arrangement: { pieces: [], holds: [], findings: [] },
    }));
    const { state, commands } = begin({ arrange });
    const before = state.view.value.turn;
    commands.look(findingOf());
    await commands.arrange();
    expect(state.view.value.turn).toBe(before + 1);
    expect(state.dressing.finding.value).toBeNull();
  });

  it('puts a file into the project that has no body yet', async () => {
    const dress = vi.fn(async (project: Project) => project);
    const { state, commands } = begin({ dress });
    state.dressing.bodies.value = [];
    await commands.takeFile('scan.obj', new Blob(['v']));
    expect(dress.mock.calls[0]!.slice(1)).toEqual(['body', { asset: 'a_1' }]);
    expect(state.dressing.stance.value).toMatchObject({ file: 'scan.obj', asset: 'a_1' });
  });

  it('puts an object beside the body under a name of its own', async () => {
    const dress = vi.fn(async (project: Project) => project);
    const { state, commands } = begin({ dress });
    state.dressing.bodies.value = [bodyOf(), bodyOf({ id: 'chair' })];
    await commands.takeFile('chair.glb', new Blob(['v']), true);
    expect(dress.mock.calls[0]!.slice(1)).toEqual(['chair_2', { asset: 'a_1' }]);
    expect(freeBodyId('.obj', [])).toBe('object');
  });

  it('shows the newest revision only, and says why a start cannot be shown', async () => {
    let answer: (bodies: ProjectBody[]) => void = () => undefined;
    const first = new Promise<ProjectBody[]>((done) => (answer = done));
    let calls = 0;
    const bodies = (): Promise<ProjectBody[]> => (calls++ === 0 ? first : Promise.resolve([bodyOf({ id: 'new' })]));
    const { state, commands } = begin({ bodies });
    const old = commands.load('p_1', 1);
    await new Promise((done) => setTimeout(done, 0));
    await commands.load('p_1', 2);
    answer([bodyOf({ id: 'old' })]);
    await old;
    expect(state.dressing.bodies.value?.[0]?.id).toBe('new');
    expect(state.dressing.startProblem.value?.code).toBe('store.not_found');
    await commands.load('p_1', 2);
    expect(calls).toBe(2);
  });

  it('flies to a finding and lights its piece up', () => {
    const { state, commands } = begin();
    state.pieces.value = ready({ pieces: [{ id: 'front' }] as never[], seams: [] });
    commands.look(findingOf());
    commands.look(findingOf());
    expect(state.selected.value).toBe('front');
    expect(state.dressing.finding.value?.turn).toBe(2);
  });
});

describe('a piece let go over a box', () => {
  it('comes to the side whose face it met, told as one looks at that side', () => {
    expect(faceOf([0, 0, 1])).toBe('front');
    expect(faceOf([0, 0, -1])).toBe('back');
    expect(faceOf([1, 0, 0])).toBe('left');
    expect(faceOf([-1, 0, 0])).toBe('right');
    expect(faceOf([0, 1, 0])).toBeNull();
    expect(onFace('front', [0.1, 0.2, 0.3])).toEqual([100, 200]);
    expect(onFace('back', [0.1, 0.2, -0.3])).toEqual([-100, 200]);
    expect(onFace('left', [0.3, 0.2, 0.1])).toEqual([-100, 200]);
    expect(onFace('right', [-0.3, 0.2, 0.1])).toEqual([100, 200]);
  });

  it('keeps the distance that it was told before', async () => {
    const place = vi.fn<DressingApi['place']>(async (project) => project);
    const { state, commands } = begin({ place });
    const there: BoxPlace = { part: 'hips', side: 'back', at_mm: [0, 0] };
    await commands.drop('front', there);
    expect(place.mock.calls[0]![1]).toMatchObject({ piece: 'front', part: 'hips', side: 'back', away_mm: 50 });
    const by_hand = { ...there, away_mm: 80, turn: 10, wrapped: true, flipped: true };
    state.dressing.check.value = {
      ready: true,
      findings: [],
      pieces: [{ id: 'front', low: [0, 0, 0], high: [1, 1, 1], by_hand, stands: by_hand }],
    };
    await commands.drop('front', { ...there, side: 'left' });
    expect(place.mock.calls[1]![1]).toMatchObject({ side: 'left', away_mm: 80, turn: 0, wrapped: false, flipped: true });
  });
});

describe('the 3D view', () => {
  it('shows the start before a drape and on the panels of body and places', () => {
    const { state } = begin();
    expect(state.beforeDrape.value).toBe(true);
    state.jobs.value = ready([jobOf()]);
    state.tab.value = 'drape';
    expect(state.beforeDrape.value).toBe(false);
    state.tab.value = 'body';
    expect(state.beforeDrape.value).toBe(true);
    state.dressing.marks.value = { tape: true, landmarks: true, boxes: true };
    expect(state.shownMarks.value).toEqual({ tape: true, landmarks: true, boxes: true });
    state.tab.value = 'arrange';
    expect(state.shownMarks.value).toEqual({ tape: false, landmarks: false, boxes: true });
  });
});
