import { describe, expect, it } from 'vitest';
import type { Api } from '../src/api/Api';
import type { Edit, Point } from '../src/api/types';
import { EditQueue } from '../src/commands/EditQueue';
import { PatternCommands } from '../src/commands/PatternCommands';
import { SeamCommands } from '../src/commands/SeamCommands';
import { RangeCommands, type PlaneSpot } from '../src/commands/RangeCommands';
import { AppState, ready } from '../src/state/AppState';
import { draftShown } from '../src/state/editing';
import { begunAt, ledTo, placeAlong, placeNear, seriesOf, snapped, tidied, toCorners, type Around } from '../src/state/seamRange';
import { seamParts } from '../src/state/seamView';
import { range } from '../src/tools/range';
import { fakeApi, projectOf, seamOf, squareOf } from './fakes';

const pieces = [squareOf('a', 0, 0, 100), squareOf('b', 0, 0, 100)];
/** b is shown beside a. */
const around: Around = { pieces, offsets: new Map([['b', [200, 0]]]), seams: [] };
const [a] = pieces;
const on = (x: number, y: number): Point => [x, y];

describe('a place on an outline', () => {
  it('is the nearest one within reach, of a piece where it is shown', () => {
    expect(placeNear(around, on(130, 50), 10)).toBeNull();
    expect(placeNear(around, on(104, 30), 10)).toMatchObject({ piece: 'a', position: 130, point: [100, 30] });
    expect(placeNear(around, on(196, 30), 10)).toMatchObject({ piece: 'b', position: 370, point: [0, 30] });
    const start = placeNear(around, on(100, 30), 10)!;
    expect(placeAlong(around, start, on(500, 60))).toMatchObject({ piece: 'a', position: 160 });
    expect(toCorners(a!, start)).toEqual({ before: 30, behind: 70 });
  });

  it('jumps to what is worth meeting, and not farther than it reaches', () => {
    const notched = { ...a!, notches: [{ at: on(100, 20), depth_mm: 0, inwards: null }] };
    const sewn = { ...seamOf('s', ['a', 'e1'], ['b', 'e3']), a: [{ piece: 'a', edge: 'e1', from: 0.7, to: 1 }] };
    const there: Around = { ...around, pieces: [notched, pieces[1]!], seams: [sewn] };
    const met = (y: number, reach = 4): [string | null, number] => {
      const place = snapped(there, placeNear(there, on(100, y), 1)!, { reach });
      return [place.snap, place.position];
    };
    expect([met(2), met(18), met(48), met(72), met(97)]).toEqual([
      ['corner', 100],
      ['notch', 120],
      ['middle', 150],
      ['sewn', 170],
      ['corner', 200],
    ]);
    expect(met(10)).toEqual([null, 110]);
    expect(met(18, 0)).toEqual([null, 118]);
    const start = placeNear(there, on(100, 97), 1)!;
    const end = placeNear(there, on(100, 66), 1)!;
    const equal = snapped(there, end, { reach: 4, equal: { start, length: 33 } });
    expect([equal.snap, equal.position, equal.point]).toEqual(['equal', 164, [100, 64]]);
  });
});

describe('a range', () => {
  const place = (x: number, y: number) => placeNear(around, on(x, y), 1)!;
  const led = (...points: Point[]) =>
    points.slice(1).reduce((drawn, point) => ledTo(a!, drawn, place(...point)), begunAt(place(...points[0]!)));

  it('is a part of an edge, in the direction in which it was drawn', () => {
    expect(seriesOf(a, led(on(20, 0), on(60, 0)))).toEqual([{ piece: 'a', edge: 'e0', from: 0.2, to: 0.6 }]);
    expect(seriesOf(a, led(on(60, 0), on(20, 0)))).toEqual([{ piece: 'a', edge: 'e0', from: 0.2, to: 0.6, reversed: true }]);
    expect(seriesOf(a, led(on(20, 0), on(20, 0)))).toEqual([]);
    expect(seriesOf(undefined, led(on(20, 0), on(60, 0)))).toEqual([]);
  });

  it('goes over corners, also that where the outline begins', () => {
    expect(seriesOf(a, led(on(80, 0), on(100, 40)))).toEqual([
      { piece: 'a', edge: 'e0', from: 0.8 },
      { piece: 'a', edge: 'e1', to: 0.4 },
    ]);
    expect(seriesOf(a, led(on(30, 0), on(0, 50)))).toEqual([
      { piece: 'a', edge: 'e0', to: 0.3, reversed: true },
      { piece: 'a', edge: 'e3', from: 0.5, reversed: true },
    ]);
    // From corner to corner there are whole edges only.
    expect(seriesOf(a, led(on(0, 0), on(60, 0), on(100, 100)))).toEqual([{ piece: 'a', edge: 'e0' }, { piece: 'a', edge: 'e1' }]);
  });

  it('is the way that the pointer went, the shorter one where it jumped, and never more than once around', () => {
    expect(led(on(50, 0), on(0, 50)).way).toBe(-100);
    expect(led(on(50, 0), on(100, 50), on(50, 100), on(0, 50)).way).toBe(300);
    const whole = led(on(50, 0), on(100, 50), on(50, 100), on(0, 50), on(50, 0));
    expect(whole.way).toBe(400);
    expect(ledTo(a!, whole, place(60, 0)).way).toBeLessThanOrEqual(400);
    const edges = seriesOf(a, whole);
    expect(edges.map(({ edge, from = 0, to = 1 }) => [edge, from, to])).toEqual([
      ['e0', 0.5, 1],
      ['e1', 0, 1],
      ['e2', 0, 1],
      ['e3', 0, 1],
      ['e0', 0, 0.5],
    ]);
  });
});

function begin(more: Partial<Api> = {}) {
  const state = new AppState();
  const sent: Edit[][] = [];
  const api = fakeApi({
    edit: async (id, revision, edits) => {
      sent.push(edits);
      return projectOf({ id, revision: revision + 1 });
    },
    ...more,
  });
  state.projects.value = ready([projectOf()]);
  state.jobs.value = ready([]);
  state.route.value = { name: 'project', id: 'p_1' };
  state.pieces.value = ready({ pieces, seams: [] });
  state.editing.offsets.value = around.offsets;
  const edits = new EditQueue(state, api, () => undefined);
  const patterns = new PatternCommands(state, api, edits);
  patterns.takeTool(range);
  return { state, sent, patterns, seams: new SeamCommands(state, api, edits), ranges: new RangeCommands(state) };
}

const spot = (x: number, y: number, reach = 0): PlaneSpot => ({ at: [x, y], catches: 10, reach });

describe('ranges that are sewn', () => {
  /** Two clicks. */
  const draw = (ranges: RangeCommands, from: Point, to: Point, stay = false): void => {
    ranges.press(spot(...from), stay);
    ranges.release(spot(...from), stay);
    ranges.point(spot(...to));
    ranges.press(spot(...to), stay);
    ranges.release(spot(...to), stay);
  };

  it('meet with the ends at which they were begun', async () => {
    for (const [from, to, same] of [
      [on(200, 20), on(200, 70), false], // upwards as on a, against b's outline
      [on(200, 70), on(200, 20), true],
    ] as const) {
      const { ranges, seams, sent } = begin();
      draw(ranges, on(100, 20), on(100, 70));
      draw(ranges, from, to);
      await seams.finishSide();
      const [seam] = sent[0]!;
      if (seam?.edit !== 'add_seam') throw new Error('no seam');
      expect([...seam.a, ...seam.b].some((use) => use.reversed)).toBe(false);
      expect(seam.same_direction).toBe(same);
      expect(seam.a).toEqual([{ piece: 'a', edge: 'e1', from: 0.2, to: 0.7 }]);
      expect(seam.b).toEqual([{ piece: 'b', edge: 'e3', from: 0.3, to: 0.8 }]);
      const [first, second] = seamParts(pieces, seam);
      expect(first!.points[0]).toEqual([100, 20]);
      expect(second!.points[0]![1]).toBeCloseTo(from[1], 6);
    }
  });

  it('are drawn by a drag as well, and shown while they are', () => {
    const { ranges, state } = begin();
    expect(ranges.press(spot(150, 50), false)).toBe(false);
    expect(ranges.press(spot(100, 20), false)).toBe(true);
    ranges.point(spot(130, 60));
    expect(draftShown(state.editing, pieces).a).toEqual([{ piece: 'a', edge: 'e1', from: 0.2, to: 0.6 }]);
    expect(state.editing.draft.value.a).toEqual([]);
    ranges.release(spot(100, 70), false);
    expect(state.editing.draft.value).toMatchObject({ a: [{ from: 0.2, to: 0.7 }], side: 'b' });
    expect(state.editing.range.value).toBeNull();
  });

  it('stay on their side with Shift, and jump to the other side’s length', () => {
    const { ranges, state } = begin();
    draw(ranges, on(100, 20), on(100, 30), true);
    draw(ranges, on(100, 60), on(100, 83));
    expect(state.editing.draft.value.a.length).toBe(2);
    ranges.press(spot(200, 10), false);
    ranges.point(spot(200, 45, 4));
    expect(state.editing.place.value).toMatchObject({ snap: 'equal' });
    expect(Math.abs(state.editing.range.value!.way)).toBeCloseTo(33, 6);
  });

  it('begin anew on another piece, and are given up from the inside out', () => {
    const { patterns, ranges, seams, state } = begin();
    draw(ranges, on(100, 20), on(100, 30));
    ranges.press(spot(100, 50), false);
    ranges.press(spot(200, 50), false);
    expect(state.editing.range.value?.start.piece).toBe('b');
    expect(patterns.cancel()).toBe(true);
    expect([state.editing.range.value, state.editing.draft.value.a.length]).toEqual([null, 1]);
    seams.leaveOut('a', 0);
    expect(state.editing.draft.value.a).toEqual([]);
    ranges.point(spot(100, 50));
    ranges.point(null);
    expect(state.editing.place.value).toBeNull();
  });
});

describe('a seam that is made tidy', () => {
  it('turns sides that run against their outlines all along, and only those', () => {
    const back = { piece: 'b', edge: 'e3', reversed: true };
    const on = { piece: 'a', edge: 'e1' };
    expect(tidied({ a: [on], b: [back], side: 'b', sameDirection: true })).toEqual({
      a: [on],
      b: [{ piece: 'b', edge: 'e3' }],
      sameDirection: false,
    });
    const mixed = [back, { piece: 'b', edge: 'e0' }];
    expect(tidied({ a: [on], b: mixed, side: 'b', sameDirection: true })).toEqual({ a: [on], b: mixed, sameDirection: true });
  });
});
