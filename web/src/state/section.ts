// A section through body and cloth at one height: both outlines, how far it is around either, the ease between, and how
// much room there is. Pure; lengths in metres, from above: x to the wearer's left, z to the front.

import type { BodyMesh } from '../api/body';
import type { ProjectBody } from '../api/dressing';
import type { ClothTopology } from '../api/frames';
import { apart, cutAt, joinedCloth, lengthOf, type CutMesh, type Outline, type Place2 } from './planeCut';

/** What a closed outline of the cloth goes around. */
export type Part = 'around' | 'trunk' | 'trunk_and_arm' | 'both_legs' | 'left_arm' | 'right_arm' | 'left_leg' | 'right_leg';

/** Room from the cloth to the body in the plane, over the length of the cloth. */
export interface Room {
  least: number;
  median: number;
  most: number;
}

export interface Girths {
  part: Part;
  /** As a tape takes it: straight over hollows. */
  body: number;
  /** Of the cloth as it hangs, and of the same way on its flat pieces. */
  worn: number;
  flat: number;
  room: Room;
  /** How many closed outlines of cloth go around it; the figures are those of the one that is shortest on the flat. */
  layers: number;
}

export interface Section {
  height: number;
  /** Between which heights there is cloth. */
  range: { low: number; high: number };
  body: Outline[];
  cloth: Outline[];
  girths: Girths[];
  /** Outlines of cloth that do not close, and how much cloth that is on the flat. */
  open: { count: number; flat: number };
}

/** A height with a name. */
export interface Level {
  name: string;
  height: number;
}

/** What of the body is shorter around than this is no part that anything goes around, m. */
const kLeastBody = 0.05;

/** Through the cloth between two heights. `person`: whether outlines are called by parts of a person. */
function sectionAt(
  height: number,
  range: Section['range'],
  body: CutMesh | null,
  cloth: CutMesh,
  person: boolean,
): Section {
  const found = body ? cutAt(body, height).filter((one) => one.length > kLeastBody) : [];
  const outer = found.filter((one) => !found.some((other) => other !== one && other.closed && goesAround(other, one)));
  const around = cutAt(cloth, height);
  const open = around.filter(({ closed }) => !closed);
  return {
    height,
    range,
    body: outer,
    cloth: around,
    girths: girthsOf(outer, around, person),
    open: { count: open.length, flat: open.reduce((sum, one) => sum + one.flat, 0) },
  };
}

/** Of the newest moment of a cloth, at the height that was asked for or where there is most to see; null before there is any. */
export function sectionOf(
  wish: { height: number | null; levels: readonly Level[] },
  body: CutMesh | null,
  { topology, positions }: { topology: ClothTopology | null; positions: Float32Array | null },
): Section | null {
  const range = clothHeights(positions);
  if (!range || !topology || positions?.length !== 3 * topology.vertexCount) return null;
  const height = wish.height ?? firstHeight(wish.levels, range);
  return sectionAt(height, range, body, joinedCloth(topology, positions), wish.levels.length > 0);
}

function girthsOf(body: readonly Outline[], cloth: readonly Outline[], person: boolean): Girths[] {
  const groups = new Map<string, { within: number[]; cloth: Outline[] }>();
  for (const outline of cloth.filter(({ closed }) => closed)) {
    const within = body.flatMap((one, i) => (goesAround(outline, one) ? [i] : []));
    if (within.length === 0) continue; // a fold, or a pocket of cloth
    const key = within.join(' ');
    const group = groups.get(key);
    if (group) group.cloth.push(outline);
    else groups.set(key, { within, cloth: [outline] });
  }
  const parts = partsOf(body);
  return [...groups.values()]
    .map(({ within, cloth: layers }) => {
      const tightest = layers.reduce((best, one) => (one.flat < best.flat ? one : best));
      const inside = within.map((i) => body[i]!);
      return {
        part: person ? wholeOf(within.map((i) => parts[i]!)) : 'around',
        body: tapeAround(inside.flatMap(({ places }) => places)),
        worn: tightest.length,
        flat: tightest.flat,
        room: roomBetween(tightest, inside),
        layers: layers.length,
      };
    })
    .sort((a, b) => b.body - a.body);
}

/** Whether a closed outline goes around another, which it does not cross. */
function goesAround({ places }: Outline, other: Outline): boolean {
  const [x, z] = other.places[0]!;
  let inside = false;
  places.forEach(([ax, az], i) => {
    const [bx, bz] = places[(i + 1) % places.length]!;
    if (az > z !== bz > z && x < ax + ((z - az) / (bz - az)) * (bx - ax)) inside = !inside;
  });
  return inside;
}

// ---- parts of a person

type Limb = Exclude<Part, 'around' | 'trunk_and_arm' | 'both_legs'>;

const middleOf = ({ places }: Outline): number => places.reduce((sum, [x]) => sum + x, 0) / places.length;
const crosses = ({ places }: Outline): boolean => places.some(([x]) => x < 0) && places.some(([x]) => x > 0);

/** Which limb each outline of a standing person is: the trunk lies across the middle; without it the inner ones are legs. */
function partsOf(body: readonly Outline[]): Limb[] {
  const trunk = body.some(crosses);
  const nearest = (side: number): number =>
    Math.min(...body.map(middleOf).filter((x) => x * side > 0).map(Math.abs), Infinity);
  const [left, right] = [nearest(1), nearest(-1)];
  return body.map((outline): Limb => {
    if (crosses(outline)) return 'trunk';
    const x = middleOf(outline);
    const inner = !trunk && Math.abs(x) === (x > 0 ? left : right);
    return `${x > 0 ? 'left' : 'right'}_${inner ? 'leg' : 'arm'}`;
  });
}

function wholeOf(limbs: readonly Limb[]): Part {
  if (limbs.length === 1) return limbs[0]!;
  return limbs.every((limb) => limb.endsWith('leg')) ? 'both_legs' : 'trunk_and_arm';
}

// ---- figures

/** How far a tape goes around places: the length of their convex hull (Andrew's monotone chain). */
export function tapeAround(places: readonly Place2[]): number {
  const sorted = [...places].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const turn = (o: Place2, a: Place2, b: Place2): number =>
    (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  const half = (ordered: readonly Place2[]): Place2[] => {
    const hull: Place2[] = [];
    for (const place of ordered) {
      while (hull.length > 1 && turn(hull[hull.length - 2]!, hull[hull.length - 1]!, place) <= 0) hull.pop();
      hull.push(place);
    }
    return hull.slice(0, -1);
  };
  return lengthOf([...half(sorted), ...half(sorted.reverse())], true);
}

/** From each stretch of the cloth's outline to the body's, weighed by how long it is. */
export function roomBetween(cloth: Outline, body: readonly Outline[]): Room {
  const sides = body.flatMap(({ places, closed }) =>
    places.flatMap((place, i) => (closed || i > 0 ? [[places.at(i - 1)!, place] as const] : [])),
  );
  const found: { room: number; length: number }[] = [];
  cloth.places.forEach((place, i) => {
    const before = cloth.places.at(i - 1)!;
    if (i === 0 && !cloth.closed) return;
    const middle: Place2 = [(before[0] + place[0]) / 2, (before[1] + place[1]) / 2];
    const room = sides.reduce((least, [a, b]) => Math.min(least, toSide(middle, a, b)), Infinity);
    found.push({ room, length: apart(before, place) });
  });
  found.sort((a, b) => a.room - b.room);
  const half = found.reduce((sum, { length }) => sum + length, 0) / 2;
  let passed = 0;
  const median = found.find(({ length }) => {
    passed += length;
    return passed >= half;
  });
  return { least: found[0]?.room ?? NaN, median: median?.room ?? NaN, most: found[found.length - 1]?.room ?? NaN };
}

function toSide(p: Place2, a: Place2, b: Place2): number {
  const [dx, dz] = [b[0] - a[0], b[1] - a[1]];
  const square = dx * dx + dz * dz;
  const along = square > 0 ? Math.min(1, Math.max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dz) / square)) : 0;
  return apart(p, [a[0] + along * dx, a[1] + along * dz]);
}

// ---- heights

const kLevels = ['bust', 'waist', 'hip'] as const;

/** Where a tape takes the girths of whoever stands there; none where that is not the body that is shown. */
export function levelsOf(bodies: readonly ProjectBody[], known: BodyMesh, shown: BodyMesh): Level[] {
  if (!sameMesh(known, shown)) return [];
  const measures = bodies.flatMap((body) => body.measures);
  return kLevels.flatMap((name) => {
    const line = measures.find((one) => one.name === name)?.line ?? [];
    return line.length === 0 ? [] : [{ name, height: line.reduce((sum, [, y]) => sum + y, 0) / line.length }];
  });
}

function sameMesh(a: BodyMesh, b: BodyMesh): boolean {
  return a === b || (a.positions.length === b.positions.length && a.positions.every((x, i) => x === b.positions[i]));
}

/** The heights at which there is cloth, m; null without any. */
export function clothHeights(positions: Float32Array | null): { low: number; high: number } | null {
  if (!positions?.length) return null;
  let [low, high] = [Infinity, -Infinity];
  for (let i = 1; i < positions.length; i += 3) {
    low = Math.min(low, positions[i]!);
    high = Math.max(high, positions[i]!);
  }
  return { low, high };
}

/** Where the plane lies that nobody has moved yet: at the waist where there is cloth, else in the cloth's middle. */
export function firstHeight(levels: readonly Level[], cloth: { low: number; high: number }): number {
  const within = levels.filter(({ height }) => height > cloth.low && height < cloth.high);
  return (within.find(({ name }) => name === 'waist') ?? within[0])?.height ?? (cloth.low + cloth.high) / 2;
}
