// What the cloth is measured for: how far it is stretched and sheared, and how much room there is to the body. A value for
// each vertex, and how values become the eight colours of the legend. Pure.

import type { ClothTopology } from '../api/frames';
import type { Piece, Point, StillWish } from '../api/types';
import type { BodySurface } from './BodySurface';
import { fixed, plain } from '../texts/numbers';
import { patternDigits, patternSign, shownMm } from '../texts/units';

export type MapKind = 'warp' | 'weft' | 'shear' | 'room' | 'curvature' | 'pressure';

export interface MapRule {
  unit: string;
  /** Ends of the scale that may be taken, in the unit; the smallest that holds nearly all of the cloth is. */
  ends: readonly number[];
  /** From −end, not from 0. */
  signed: boolean;
  /** Small values are red: where cloth is near to the body it is tight. */
  smallIsRed: boolean;
  /** Decimals of a value that is pointed at. */
  digits: number;
  /** Left by the service with a drape that has ended; others are measured here, also while it drapes. */
  kept: boolean;
  /** Nothing without a body. */
  toBody: boolean;
}

const kHere = { signed: false, smallIsRed: false, digits: 1, kept: false, toBody: false };
const kStretch: MapRule = { ...kHere, unit: '%', ends: [1, 2, 4, 8, 20, 40], signed: true };

/** Scales as core/analysis/cloth_map has them. */
export const kMaps: Record<MapKind, MapRule> = {
  warp: kStretch,
  weft: kStretch,
  shear: { ...kHere, unit: '°', ends: [2, 4, 8, 16, 40] },
  room: { ...kHere, unit: 'mm', ends: [8, 16, 40, 80, 160], smallIsRed: true, toBody: true },
  curvature: { ...kHere, unit: '1/m', ends: [4, 8, 20, 40, 80, 200], signed: true, kept: true },
  pressure: { ...kHere, unit: 'kPa', ends: [0.2, 0.4, 0.8, 2, 4, 8, 20], digits: 2, kept: true, toBody: true },
};

export const kMapKinds = Object.keys(kMaps) as readonly MapKind[];

/** What the service calls a map. */
export const kServiceMaps: Record<MapKind, NonNullable<StillWish['map']>> = {
  warp: 'warp',
  weft: 'weft',
  shear: 'shear',
  room: 'ease',
  curvature: 'curvature',
  pressure: 'pressure',
};

/** The cloth as it looks, then one map after the other of those that can be shown. */
export function nextMap(now: MapKind | null, isMissing: (kind: MapKind) => boolean): MapKind | null {
  const kinds = [null, ...kMapKinds.filter((kind) => kind === now || !isMissing(kind))];
  return kinds[(kinds.indexOf(now) + 1) % kinds.length]!;
}

/** From blue to red. */
export const kBands = ['#2b4ea2', '#4c86c8', '#8ec1e2', '#cfe5ef', '#f8e4bd', '#f6b475', '#e26d49', '#b6262c'] as const;

/** A map of one moment of the cloth. */
export interface ClothMap {
  kind: MapKind;
  /** Of each vertex, in the map's unit; NaN where nothing can be said. */
  values: Float32Array;
  /** End of the scale, in the unit. */
  end: number;
}

/** So much of the cloth lies within the scale. */
const kWithin = 0.98;

/** With the scale that fits; several maps share the widest of theirs (`ofOneScale`). */
export function mapOf(kind: MapKind, values: Float32Array): ClothMap {
  const sizes = values.filter((value) => Number.isFinite(value)).map(Math.abs).sort();
  const most = sizes[Math.min(sizes.length - 1, Math.floor(kWithin * sizes.length))] ?? 0;
  const { ends } = kMaps[kind];
  return { kind, values, end: ends.find((end) => end >= most) ?? ends[ends.length - 1]! };
}

export function ofOneScale(maps: readonly (ClothMap | null)[]): (ClothMap | null)[] {
  const end = Math.max(...maps.map((map) => map?.end ?? 0));
  return maps.map((map) => map && { ...map, end });
}

const lowOf = ({ kind, end }: ClothMap): number => (kMaps[kind].signed ? -end : 0);

/** Number of the colour of a value. */
export function bandOf(map: ClothMap, value: number): number {
  const low = lowOf(map);
  const band = Math.floor((kBands.length * (value - low)) / (map.end - low));
  const within = Math.min(kBands.length - 1, Math.max(0, band));
  return kMaps[map.kind].smallIsRed ? kBands.length - 1 - within : within;
}

/** Where each band begins and the last ends, in the unit, from the first colour on. */
export function bandEnds(map: ClothMap): number[] {
  const low = lowOf(map);
  const ends = Array.from({ length: kBands.length + 1 }, (_, i) => low + ((map.end - low) * i) / kBands.length);
  return kMaps[map.kind].smallIsRed ? ends.reverse() : ends;
}

/** What a map's figures are in: room is a length, in the unit that was chosen. */
export const mapUnit = (kind: MapKind): string => (kMaps[kind].unit === 'mm' ? patternSign() : kMaps[kind].unit);

const inUnit = (kind: MapKind, value: number): number => (kMaps[kind].unit === 'mm' ? shownMm(value) : value);

/** "−0.75", "10": no more digits than bands need, one more than a value has that is pointed at. */
export const bandFigure = (kind: MapKind, value: number): string => plain(inUnit(kind, value), kMaps[kind].digits + 1).replace('-', '−');

function shownIn(kind: MapKind, value: number): string {
  const digits = kMaps[kind].unit === 'mm' ? patternDigits(1) : kMaps[kind].digits;
  return fixed(inUnit(kind, value), digits).replace('-', '−');
}

export const valueText = (map: Pick<ClothMap, 'kind'>, value: number): string =>
  Number.isFinite(value) ? `${shownIn(map.kind, value)} ${mapUnit(map.kind)}` : '–';

/** Of a strained triangle: both directions' lengths for 1, and the angle that is missing between them, degrees. */
interface Strained {
  warp: number;
  weft: number;
  shear: number;
}

type Vec = readonly [number, number, number];
const between = (p: Float32Array, a: number, b: number): Vec => [
  p[3 * b]! - p[3 * a]!,
  p[3 * b + 1]! - p[3 * a + 1]!,
  p[3 * b + 2]! - p[3 * a + 2]!,
];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const mixed = (a: Vec, s: number, b: Vec, t: number): Vec => [
  s * a[0] + t * b[0],
  s * a[1] + t * b[1],
  s * a[2] + t * b[2],
];

/** A flat triangle's two sides from its first corner in weft and warp, and the area they span; m. */
function flatSides(rest: Float32Array, corners: readonly number[], [gx, gy]: Point) {
  const [a, b, c] = corners as [number, number, number];
  const turned = (v: number): Point => {
    const [x, y] = [rest[2 * v]! - rest[2 * a]!, rest[2 * v + 1]! - rest[2 * a + 1]!];
    return [gy * x - gx * y, gx * x + gy * y];
  };
  const [u, v] = [turned(b), turned(c)];
  return { u, v, area: u[0] * v[1] - u[1] * v[0] };
}

function strained(rest: Float32Array, positions: Float32Array, corners: readonly number[], grain: Point): Strained | null {
  const { u, v, area } = flatSides(rest, corners, grain);
  if (Math.abs(area) < 1e-12) return null;
  const [a, b, c] = corners as [number, number, number];
  const [p, q] = [between(positions, a, b), between(positions, a, c)];
  const weft = mixed(p, v[1] / area, q, -u[1] / area);
  const warp = mixed(p, -v[0] / area, q, u[0] / area);
  const [across, along] = [Math.sqrt(dot(weft, weft)), Math.sqrt(dot(warp, warp))];
  const lean = Math.min(1, Math.max(-1, dot(weft, warp) / Math.max(across * along, 1e-12)));
  return { warp: 100 * (along - 1), weft: 100 * (across - 1), shear: (Math.abs(Math.asin(lean)) * 180) / Math.PI };
}

/** Each vertex has the mean of its triangles. `grains`: direction of the warp by piece; upright where none is told. */
export function strainValues(
  kind: 'warp' | 'weft' | 'shear',
  topology: ClothTopology,
  positions: Float32Array,
  grains: ReadonlyMap<string, Point>,
): Float32Array {
  const { triangles, rest, vertexCount } = topology;
  const grainOf = new Array<Point>(vertexCount).fill([0, 1]);
  for (const { id, firstVertex, vertexCount: count } of topology.pieces)
    grainOf.fill(unit(grains.get(id) ?? [0, 1]), firstVertex, firstVertex + count);
  const sums = new Float32Array(vertexCount);
  const counts = new Uint16Array(vertexCount);
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!];
    const found = strained(rest, positions, corners, grainOf[corners[0]!]!);
    if (!found) continue;
    for (const v of corners) {
      sums[v]! += found[kind];
      counts[v]! += 1;
    }
  }
  return sums.map((sum, v) => (counts[v]! > 0 ? sum / counts[v]! : NaN));
}

const unit = ([x, y]: Point): Point => {
  const length = Math.hypot(x, y) || 1;
  return [x / length, y / length];
};

/** mm from each vertex to the body's surface; further than `most` mm counts as that. */
export function roomValues(surface: BodySurface, positions: Float32Array, most = 150): Float32Array {
  const values = new Float32Array(positions.length / 3);
  for (let v = 0; v < values.length; ++v) {
    values[v] = 1000 * surface.distance(positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!, most / 1000);
  }
  return values;
}

export interface MeasuredCloth {
  topology: ClothTopology | null;
  positions: Float32Array | null;
}

/** Of a moment of the cloth, what can be measured here; null where nothing can. `surface`: of the body; null: there is none. */
export function measured(
  kind: MapKind,
  { topology, positions }: MeasuredCloth,
  grains: ReadonlyMap<string, Point>,
  surface: () => BodySurface | null,
): Float32Array | null {
  if (!topology || positions?.length !== 3 * topology.vertexCount) return null;
  if (kind === 'warp' || kind === 'weft' || kind === 'shear') return strainValues(kind, topology, positions, grains);
  const around = kind === 'room' ? surface() : null;
  return around && roomValues(around, positions);
}

/** Directions of the warp by piece. */
export const grainsOf = (pieces: readonly Pick<Piece, 'id' | 'grain'>[]): Map<string, Point> =>
  new Map(pieces.map(({ id, grain }) => [id, grain ?? [0, 1]]));

/** The triangles of a piece by their colour, as paths on the flat pattern in mm, y down; empty where none has it. */
export function bandPaths(map: ClothMap, { pieces, triangles, rest }: ClothTopology, id: string): string[] {
  const paths = kBands.map((): string[] => []);
  const piece = pieces.find((one) => one.id === id);
  if (!piece) return [];
  const end = piece.firstVertex + piece.vertexCount;
  const at = (v: number): string => `${(1000 * rest[2 * v]!).toFixed(1)} ${(-1000 * rest[2 * v + 1]!).toFixed(1)}`;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!];
    if (a < piece.firstVertex || a >= end) continue;
    const value = (map.values[a]! + map.values[b]! + map.values[c]!) / 3;
    if (Number.isFinite(value)) paths[bandOf(map, value)]!.push(`M${at(a)}L${at(b)}L${at(c)}Z`);
  }
  return paths.map((parts) => parts.join(''));
}

/** The value at the vertex of a piece that lies nearest to a place of the flat pattern, mm; NaN far from all. */
export function valueAt(map: ClothMap, { pieces, rest }: ClothTopology, id: string, [x, y]: Point): number {
  const piece = pieces.find((one) => one.id === id);
  if (!piece) return NaN;
  let best = NaN;
  let nearest = 60;
  for (let v = piece.firstVertex; v < piece.firstVertex + piece.vertexCount; ++v) {
    const far = Math.hypot(1000 * rest[2 * v]! - x, 1000 * rest[2 * v + 1]! - y);
    if (far >= nearest) continue;
    nearest = far;
    best = map.values[v]!;
  }
  return best;
}
