import { afterEach, describe, expect, it, vi } from 'vitest';
import type { ClothTopology } from '../src/api/frames';
import { BodySurface } from '../src/state/BodySurface';
import { MapKeeper } from '../src/commands/MapKeeper';
import { AppState, ready } from '../src/state/AppState';
import { bandEnds, bandOf, bandPaths, mapOf, nextMap, roomValues, strainValues, valueAt, valueText, type MapKind } from '../src/state/clothMaps';

/** A square of 10 cm, cut in two triangles, as one piece. */
const square: ClothTopology = {
  epoch: 0,
  vertexCount: 4,
  origin: [0, 0, 0],
  step: 1e-4,
  pieces: [{ id: 'a', firstVertex: 0, vertexCount: 4, colour: [1, 1, 1] }],
  rest: new Float32Array([0, 0, 0.1, 0, 0.1, 0.1, 0, 0.1]),
  triangles: new Uint32Array([0, 1, 2, 0, 2, 3]),
  sewn: new Uint32Array(0),
};
/** Where the square's corners lie when x and y are stretched and x leans over y. */
const laid = (x: number, y: number, lean = 0): Float32Array =>
  new Float32Array(
    [
      [0, 0],
      [0.1, 0],
      [0.1, 0.1],
      [0, 0.1],
    ].flatMap(([u, v]) => [x * u! + lean * v!, y * v!, 0.3]),
  );
const upright = new Map([['a', [0, 1] as [number, number]]]);

describe('a map of the cloth', () => {
  it('tells stretch along the warp and along the weft apart', () => {
    const positions = laid(1.02, 0.99);
    for (const value of strainValues('weft', square, positions, upright)) expect(value).toBeCloseTo(2, 3);
    for (const value of strainValues('warp', square, positions, upright)) expect(value).toBeCloseTo(-1, 3);
    const across = new Map([['a', [5, 0] as [number, number]]]);
    for (const value of strainValues('warp', square, positions, across)) expect(value).toBeCloseTo(2, 3);
  });

  it('tells shear as the angle that is missing between warp and weft', () => {
    for (const value of strainValues('shear', square, laid(1, 1, Math.tan(Math.PI / 18)), upright))
      expect(value).toBeCloseTo(10, 2);
    for (const value of strainValues('shear', square, laid(1.1, 1), upright)) expect(value).toBeCloseTo(0, 4);
  });

  it('tells the room to the nearest place of the body, also beside its triangles', () => {
    const body = { positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), indices: new Uint32Array([0, 1, 2]) };
    const places = new Float32Array([0.2, 0.2, 0.03, -0.04, 0, 0.03, 1.1, 0, 0, 0.5, 0.5, 0.9]);
    const values = roomValues(new BodySurface(body), places);
    [30, 50, 100, 150].forEach((mm, i) => expect(values[i]).toBeCloseTo(mm, 2));
  });

  it('finds the same nearest place as a look at all triangles', () => {
    // Triangles and places by a fixed rule, scattered within a metre.
    const at = (n: number): number => ((n * 7919) % 1009) / 1009;
    const positions = new Float32Array(90).map((_, i) => (i % 9 < 3 ? at(i) : at(i - (i % 9) + (i % 3)) + 0.06 * at(i + 50)));
    const indices = new Uint32Array(30).map((_, i) => i);
    const surface = new BodySurface({ positions, indices });
    for (let n = 0; n < 40; ++n) {
      const place = [at(3 * n + 1), at(5 * n + 2), at(11 * n + 3)] as const;
      const alone = Array.from({ length: 10 }, (_, t) =>
        new BodySurface({ positions, indices: indices.slice(3 * t, 3 * t + 3) }).distance(...place, 0.5),
      );
      expect(surface.distance(...place, 0.5)).toBeCloseTo(Math.min(...alone), 9);
    }
  });

  it('has a scale that holds nearly all of the cloth, in eight bands from blue to red', () => {
    const values = new Float32Array(100).fill(1.5);
    values[7] = -30;
    const map = mapOf('warp', values);
    expect(map.end).toBe(2);
    expect(bandEnds(map)).toEqual([-2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 2]);
    expect([-30, -0.1, 0, 1.9, 99].map((value) => bandOf(map, value))).toEqual([0, 3, 4, 7, 7]);
    const room = mapOf('room', new Float32Array([3, 5, NaN]));
    expect(room.end).toBe(8);
    expect([0, 7.9].map((value) => bandOf(room, value))).toEqual([7, 0]);
    expect(bandEnds(room)[0]).toBe(8);
    expect([valueText(room, 3.04), valueText(room, NaN)]).toEqual(['3.0 mm', '–']);
  });

  it('lies on the flat pieces as well, with its value under the pointer', () => {
    const map = mapOf('warp', new Float32Array([0, 0, 0, 3.9]));
    const paths = bandPaths(map, square, 'a');
    expect(paths.map((path, band) => (path ? band : -1)).filter((band) => band >= 0)).toEqual([4, 5]);
    expect(paths[4]).toBe('M0.0 0.0L100.0 0.0L100.0 -100.0Z');
    expect(valueAt(map, square, 'a', [2, 97])).toBeCloseTo(3.9);
    expect(valueAt(map, square, 'a', [500, 0])).toBeNaN();
    expect(valueAt(map, square, 'gone', [0, 0])).toBeNaN();
    expect(bandPaths(map, square, 'gone')).toEqual([]);
  });
});

describe('the map that is shown', () => {
  afterEach(() => void vi.useRealTimers());
  const moment = { epoch: 0, seq: 1, step: 1, time: 0 };
  const draped = (): AppState => {
    const state = new AppState();
    new MapKeeper(state, null).start();
    state.cloth.setTopology(square);
    state.cloth.setPositions(laid(1.02, 1), moment);
    return state;
  };

  it('is measured as soon as it is chosen, and again with the frames that follow', () => {
    vi.useFakeTimers();
    const state = draped();
    expect(state.clothMap.value).toBeNull();
    state.mapKind.value = 'weft';
    expect(state.clothMap.value!.values[0]).toBeCloseTo(2, 3);
    state.cloth.setPositions(laid(1.05, 1), moment);
    vi.runAllTimers();
    expect(state.clothMap.value!.values[0]).toBeCloseTo(5, 3);
    state.mapKind.value = null;
    expect(state.clothMap.value).toBeNull();
  });

  it('of the room waits for the body, and goes with the cloth', () => {
    vi.useFakeTimers();
    const state = draped();
    state.mapKind.value = 'room';
    expect(state.clothMap.value).toBeNull();
    state.body.value = ready({ positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), indices: new Uint32Array([0, 1, 2]) });
    expect(state.clothMap.value!.values[0]).toBeCloseTo(150, 2);
    state.cloth.clear();
    expect(state.clothMap.value).toBeNull();
  });

  it('is followed by the next, and the last by the cloth as it looks', () => {
    const all = (): boolean => false;
    expect(nextMap(null, all)).toBe('warp');
    expect(nextMap('pressure', all)).toBeNull();
    const whileItDrapes = (kind: MapKind): boolean => kind === 'curvature' || kind === 'pressure';
    expect(nextMap('room', whileItDrapes)).toBeNull();
    expect(nextMap('curvature', whileItDrapes)).toBeNull();
  });
});
