import { describe, expect, it, vi } from 'vitest';
import type { BodyMesh } from '../src/api/body';
import type { ProjectBody } from '../src/api/dressing';
import type { ClothTopology } from '../src/api/frames';
import { SectionKeeper } from '../src/commands/SectionKeeper';
import { AppState, ready } from '../src/state/AppState';
import { cutAt, joinedBody, joinedCloth, type CutMesh, type Outline, type Place2 } from '../src/state/planeCut';
import { clothHeights, firstHeight, levelsOf, roomBetween, sectionOf, tapeAround, type Section } from '../src/state/section';
import { jobOf, projectOf } from './fakes';

/** How many sides a round thing has: its outline is shorter than the circle's by 0.3 %. */
const kSides = 24;
const chord = 2 * Math.sin(Math.PI / kSides);
const around = (radius: number): number => kSides * chord * radius;

interface Tube {
  radius: number;
  x?: number;
  low?: number;
  high?: number;
  /** How many of its sides there are; fewer than all: it does not close. */
  sides?: number;
}

/** A round wall about an upright axis, as triangles with vertices of their own at the seam. */
function tube({ radius, x = 0, low = 0, high = 1, sides = kSides }: Tube) {
  const positions: number[] = [];
  const rest: number[] = [];
  const triangles: number[] = [];
  for (let i = 0; i <= sides; ++i) {
    const angle = (2 * Math.PI * (i % kSides)) / kSides;
    for (const y of [low, high]) {
      positions.push(x + radius * Math.sin(angle), y, radius * Math.cos(angle));
      rest.push(1.1 * i * chord * radius, y); // cut a tenth wider than it hangs
    }
    if (i < sides) triangles.push(2 * i, 2 * i + 2, 2 * i + 1, 2 * i + 1, 2 * i + 2, 2 * i + 3);
  }
  return { positions, rest, triangles, seam: [0, 2 * sides, 1, 2 * sides + 1] };
}

function clothOf(tubes: Tube[], sewn = true): { topology: ClothTopology; positions: Float32Array } {
  const all = { positions: [] as number[], rest: [] as number[], triangles: [] as number[], sewn: [] as number[] };
  for (const one of tubes.map(tube)) {
    const first = all.positions.length / 3;
    all.positions.push(...one.positions);
    all.rest.push(...one.rest);
    all.triangles.push(...one.triangles.map((v) => v + first));
    if (sewn) all.sewn.push(...one.seam.map((v) => v + first));
  }
  const vertexCount = all.positions.length / 3;
  const topology = {
    epoch: 0,
    vertexCount,
    origin: [0, 0, 0] as [number, number, number],
    step: 1e-4,
    pieces: [{ id: 'a', firstVertex: 0, vertexCount, colour: [1, 1, 1] as [number, number, number] }],
    rest: new Float32Array(all.rest),
    triangles: new Uint32Array(all.triangles),
    sewn: new Uint32Array(all.sewn),
  };
  return { topology, positions: new Float32Array(all.positions) };
}

function bodyOf(tubes: Tube[]): BodyMesh {
  const { topology, positions } = clothOf(tubes);
  return { positions, indices: topology.triangles };
}

const outlinesOf = (tubes: Tube[], height: number, sewn = true): Outline[] => {
  const { topology, positions } = clothOf(tubes, sewn);
  return cutAt(joinedCloth(topology, positions), height);
};

const levels = [
  { name: 'bust', height: 0.8 },
  { name: 'waist', height: 0.5 },
];
const cutOf = (body: Tube[], cloth: Tube[], height: number | null = 0.4, known = levels): Section =>
  sectionOf({ height, levels: known }, joinedBody(bodyOf(body)), clothOf(cloth))!;

describe('a level plane through a mesh', () => {
  it('leaves one closed outline of a sewn wall, with its length in space and on the flat', () => {
    const [outline, ...others] = outlinesOf([{ radius: 0.2 }], 0.37);
    expect(others).toEqual([]);
    expect(outline!.closed).toBe(true);
    // Two triangles a side: the outline has their diagonals' places too, on the same line.
    expect(outline!.length).toBeCloseTo(around(0.2), 6);
    expect(outline!.flat).toBeCloseTo(1.1 * around(0.2), 6);
  });

  it('leaves an open outline where a seam is not sewn, or stands open by more than a centimetre', () => {
    expect(outlinesOf([{ radius: 0.2 }], 0.37, false).map(({ closed }) => closed)).toEqual([false]);
    const { topology, positions } = clothOf([{ radius: 0.2 }]);
    const part = (by: number): boolean[] => {
      const apart = positions.slice();
      for (const v of [topology.sewn[1]!, topology.sewn[3]!]) apart[3 * v]! += by;
      return cutAt(joinedCloth(topology, apart), 0.37).map(({ closed }) => closed);
    };
    expect(part(0.008)).toEqual([true]);
    expect(part(0.012)).toEqual([false]);
  });

  it('goes through a plane on which vertices lie, and misses what is above or below', () => {
    expect(outlinesOf([{ radius: 0.2, low: 0.3 }], 0.3)).toEqual([]);
    const [low, high] = [outlinesOf([{ radius: 0.2 }], 1), outlinesOf([{ radius: 0.2 }], 1.001)];
    expect([low.length, low[0]!.closed, high]).toEqual([1, true, []]);
  });

  it('keeps an outline closed where a third piece is sewn to it', () => {
    const wall = clothOf([{ radius: 0.2 }]);
    const count = wall.topology.vertexCount;
    // A flap that is sewn to two upright neighbours of the wall.
    const flap = [wall.positions.slice(12, 15), wall.positions.slice(15, 18)].flatMap((place) => [...place]);
    const positions = new Float32Array([...wall.positions, ...flap, 0.5, 0.2, 0.5]);
    const topology = {
      ...wall.topology,
      vertexCount: count + 3,
      rest: new Float32Array([...wall.topology.rest, 0, 0, 0, 1, 1, 0]),
      triangles: new Uint32Array([...wall.topology.triangles, count, count + 1, count + 2]),
      sewn: new Uint32Array([...wall.topology.sewn, 4, count, 5, count + 1]),
    };
    const found = cutAt(joinedCloth(topology, positions), 0.37);
    expect(found.map(({ closed }) => closed).sort()).toEqual([false, true]);
    expect(found.find(({ closed }) => closed)!.length).toBeCloseTo(around(0.2), 6);
  });

  it('takes vertices of a body that lie in one place for one', () => {
    const body = bodyOf([{ radius: 0.15 }]);
    const alone: CutMesh = { positions: body.positions, triangles: body.indices };
    expect(cutAt(alone, 0.5)[0]!.closed).toBe(false);
    expect(cutAt(joinedBody(body), 0.5)[0]!.closed).toBe(true);
  });
});

describe('a section', () => {
  it('sets the cloth’s flat girth beside the body’s, with the room between', () => {
    const [girths, ...others] = cutOf([{ radius: 0.15 }], [{ radius: 0.2 }]).girths;
    expect(others).toEqual([]);
    expect(girths).toMatchObject({ part: 'trunk', layers: 1 });
    expect(girths!.body).toBeCloseTo(around(0.15), 6);
    expect(girths!.worn).toBeCloseTo(around(0.2), 6);
    expect(girths!.flat - girths!.body).toBeCloseTo(1.1 * around(0.2) - around(0.15), 6);
    expect(girths!.room.least).toBeCloseTo(0.05, 2);
    expect(girths!.room.median).toBeCloseTo(0.05, 2);
  });

  it('tells the tightest of several layers, and counts them', () => {
    const { girths } = cutOf([{ radius: 0.15 }], [{ radius: 0.3 }, { radius: 0.2 }]);
    expect(girths).toHaveLength(1);
    expect(girths[0]!.layers).toBe(2);
    expect(girths[0]!.worn).toBeCloseTo(around(0.2), 6);
  });

  it('knows trunk and arms, legs, and a skirt around both', () => {
    const parts = (body: Tube[], cloth: Tube[], known = levels): string[] =>
      cutOf(body, cloth, 0.4, known).girths.map(({ part }) => part);
    const trunk = { radius: 0.15 };
    const [leftArm, rightArm] = [{ radius: 0.04, x: 0.35 }, { radius: 0.05, x: -0.35 }];
    const wide = (one: Tube): Tube => ({ ...one, radius: one.radius + 0.02 });
    expect(parts([trunk, leftArm, rightArm], [trunk, leftArm, rightArm].map(wide))).toEqual([
      'trunk',
      'right_arm',
      'left_arm',
    ]);
    const [leftLeg, rightLeg] = [{ radius: 0.08, x: 0.11 }, { radius: 0.09, x: -0.11 }];
    expect(parts([leftLeg, rightLeg, leftArm], [leftLeg, rightLeg, leftArm].map(wide))).toEqual([
      'right_leg',
      'left_leg',
      'left_arm',
    ]);
    const skirt = cutOf([leftLeg, rightLeg], [{ radius: 0.3 }]).girths;
    expect(skirt.map(({ part }) => part)).toEqual(['both_legs']);
    expect(skirt[0]!.body).toBeGreaterThan(around(0.09) + 2 * 0.22 * 0.9);
    expect(parts([trunk, leftArm], [{ radius: 0.5 }])).toEqual(['trunk_and_arm']);
    expect(parts([trunk], [{ radius: 0.2 }], [])).toEqual(['around']);
  });

  it('counts outlines that do not close, and no fold that goes around nobody', () => {
    const { girths, open } = cutOf([{ radius: 0.15 }], [{ radius: 0.2, sides: 20 }, { radius: 0.05, x: 0.6 }]);
    expect(girths).toEqual([]);
    expect(open.count).toBe(1);
    expect(open.flat).toBeCloseTo((1.1 * around(0.2) * 20) / kSides, 5);
  });

  it('lies where there is cloth: at the waist at first, then where it was put', () => {
    expect(cutOf([{ radius: 0.15 }], [{ radius: 0.2, high: 0.9 }], null).height).toBe(0.5);
    expect(cutOf([{ radius: 0.15 }], [{ radius: 0.2, low: 0.6, high: 0.9 }], null).height).toBe(0.8);
    expect(cutOf([{ radius: 0.15 }], [{ radius: 0.2, high: 0.3 }], null).height).toBeCloseTo(0.15, 6);
    expect(cutOf([{ radius: 0.15 }], [{ radius: 0.2, high: 0.9 }], 0.7).height).toBe(0.7);
    expect(clothHeights(null)).toBeNull();
    expect(firstHeight([], { low: 1, high: 2 })).toBe(1.5);
    expect(sectionOf({ height: 0.4, levels }, null, { topology: null, positions: null })).toBeNull();
  });
});

describe('figures of a section', () => {
  it('are taken as a tape does, straight over hollows', () => {
    const places: Place2[] = [[0, 0], [1, 0], [0.5, 0.4], [1, 1], [0, 1], [0.5, 0.5]];
    expect(tapeAround(places)).toBeCloseTo(4, 9);
  });

  it('weigh room by the length of the cloth', () => {
    const line = (places: Place2[]): Outline => ({ places, closed: false, length: 0, flat: 0 });
    // A short way near the wall, a long one far from it.
    const room = roomBetween(line([[0, 0.01], [0.1, 0.01], [0.1, 0.05], [1.1, 0.05]]), [line([[-1, 0], [2, 0]])]);
    expect(room.least).toBeCloseTo(0.01, 9);
    expect(room.median).toBeCloseTo(0.05, 9);
    expect(room.most).toBeCloseTo(0.05, 9);
  });

  it('have names of heights only while the project’s body is the drape’s', () => {
    const body = bodyOf([{ radius: 0.15 }]);
    const figures = [
      { measures: [{ name: 'waist', line: [[0, 0.9, 0], [0, 1, 0]] }, { name: 'hip', line: [] }] },
    ] as unknown as ProjectBody[];
    expect(levelsOf(figures, body, bodyOf([{ radius: 0.15 }]))).toEqual([{ name: 'waist', height: 0.95 }]);
    expect(levelsOf(figures, bodyOf([{ radius: 0.16 }]), body)).toEqual([]);
  });
});

describe('the section that is shown', () => {
  function draped() {
    const state = new AppState();
    const body = bodyOf([{ radius: 0.15 }]);
    const api = {
      bodies: vi.fn(async () => [{ measures: [{ name: 'bust', line: [[0, 0.8, 0]] }] }] as unknown as ProjectBody[]),
      mesh: vi.fn(async () => body),
    };
    state.projects.value = ready([projectOf()]);
    state.jobs.value = ready([jobOf({ state: 'succeeded', results: { 'final.obj': 1 } })]);
    state.route.value = { name: 'project', id: 'p_1' };
    state.body.value = ready(body);
    new SectionKeeper(state, api).start();
    const { topology, positions } = clothOf([{ radius: 0.2 }]);
    state.cloth.setTopology(topology);
    state.cloth.setPositions(positions, { epoch: 0, seq: 1, step: 0, time: 0 });
    return { state, api, positions };
  }

  it('is cut once it is asked for, at heights that the service knows of', async () => {
    const { state, api } = draped();
    expect([state.section.cut.value, api.bodies.mock.calls]).toEqual([null, []]);
    state.section.shown.value = true;
    expect(state.section.cut.value?.height).toBe(0.5);
    await vi.waitFor(() => expect(state.section.levels.value).toEqual([{ name: 'bust', height: 0.8 }]));
    expect(state.section.cut.value).toMatchObject({ height: 0.8, girths: [{ part: 'trunk' }] });
    expect(api.mesh).toHaveBeenCalledTimes(1);
    state.section.height.value = 0.25;
    expect(state.section.cut.value?.height).toBe(0.25);
    state.section.shown.value = false;
    expect(state.section.cut.value).toBeNull();
  });

  it('follows the cloth, and goes with it', () => {
    vi.useFakeTimers();
    const { state, positions } = draped();
    state.section.shown.value = true;
    const before = state.section.cut.value!.girths[0]!.worn;
    state.cloth.setPositions(positions.map((x) => 1.1 * x), { epoch: 0, seq: 2, step: 1, time: 0.1 });
    vi.advanceTimersByTime(1000);
    expect(state.section.cut.value!.girths[0]!.worn).toBeCloseTo(1.1 * before, 5);
    state.cloth.clear();
    expect(state.section.cut.value).toBeNull();
    vi.useRealTimers();
  });

  it('says why there are no names of heights, and asks again', async () => {
    const { state, api } = draped();
    api.bodies.mockRejectedValueOnce(new Error('no'));
    state.section.shown.value = true;
    await vi.waitFor(() => expect(state.notices.value).toHaveLength(1));
    state.section.shown.value = false;
    state.section.shown.value = true;
    await vi.waitFor(() => expect(state.section.levels.value).toHaveLength(1));
  });
});
