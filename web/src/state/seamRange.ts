// A range of an outline between two points, to sew a part of an edge to a part of another: where a pointer is along the
// outline, what it jumps to there, and the edges that a range comes to. Pure; millimetres, along the outline's own direction.

import type { Piece, PieceEdge, Point, SeamEdge, SeamSides } from '../api/types';
import { minus, nearestOn } from './outline';
import { alongLine, type SeamDraft } from './seamView';

/** What a place was taken from; null: from the pointer alone. */
export type Snap = 'corner' | 'middle' | 'notch' | 'sewn' | 'equal' | null;

/** A place on the outline of a piece, or around one of its holes. */
export interface LoopPlace {
  piece: string;
  loop: number;
  /** From where the first edge of the loop begins. */
  position: number;
  /** In its piece. */
  point: Point;
  snap: Snap;
}

/** What is being drawn. */
export interface RangeDraft {
  start: LoopPlace;
  /** Where it ends at the moment. */
  end: LoopPlace;
  /** From start to end, less than nothing against the outline; no longer than the outline. */
  way: number;
}

interface LoopEdge {
  edge: PieceEdge;
  /** Its place in the loop. */
  from: number;
}

interface Loop {
  edges: LoopEdge[];
  length: number;
}

/** Shorter than this there is no range. */
export const kShortest = 0.5;

function loopOf(piece: Piece, loop: number): Loop {
  const edges: LoopEdge[] = [];
  let length = 0;
  for (const edge of piece.edges) {
    if (edge.loop !== loop) continue;
    edges.push({ edge, from: length });
    length += edge.length_mm;
  }
  return { edges, length };
}

const within = (position: number, length: number): number => ((position % length) + length) % length;

/** How far two positions of a loop are apart, the shorter way. */
function apart(a: number, b: number, length: number): number {
  const off = within(a - b, length);
  return Math.min(off, length - off);
}

/** The edge with a position, and its fraction there. A corner belongs to the edge that it begins. */
function edgeAt({ edges, length }: Loop, position: number): { edge: PieceEdge; at: number } | null {
  const wanted = within(position, length);
  const found = [...edges].reverse().find(({ from }) => from <= wanted + 1e-9);
  if (!found || found.edge.length_mm <= 0) return null;
  return { edge: found.edge, at: Math.min(1, Math.max(0, (wanted - found.from) / found.edge.length_mm)) };
}

function pointAt(loop: Loop, position: number): Point {
  const found = edgeAt(loop, position);
  return (found && alongLine(found.edge.points, found.at)?.at) ?? [0, 0];
}

/** The two corners that a place lies between, by how far they are. */
export function toCorners(piece: Piece, place: LoopPlace): { before: number; behind: number } {
  const found = edgeAt(loopOf(piece, place.loop), place.position);
  if (!found) return { before: 0, behind: 0 };
  const before = found.at * found.edge.length_mm;
  return { before, behind: found.edge.length_mm - before };
}

export interface Around {
  pieces: readonly Piece[];
  /** Where pieces are shown, by their id. */
  offsets: ReadonlyMap<string, Point>;
  seams: readonly SeamSides[];
}

interface Near {
  piece: Piece;
  edge: PieceEdge;
  at: number;
  far: number;
}

function nearestOf(pieces: readonly Piece[], offsets: Around['offsets'], to: Point, loop: number | null): Near | null {
  let best: Near | null = null;
  for (const piece of pieces) {
    const inPiece = minus(to, offsets.get(piece.id) ?? [0, 0]);
    for (const edge of piece.edges) {
      if (edge.curves.length === 0 || (loop !== null && edge.loop !== loop)) continue;
      const { at, distance: far } = nearestOn(edge, inPiece);
      if (!best || far < best.far) best = { piece, edge, at, far };
    }
  }
  return best;
}

function placeOf({ piece, edge, at }: Near): LoopPlace {
  const loop = loopOf(piece, edge.loop);
  const from = loop.edges.find((one) => one.edge === edge)!.from;
  const position = within(from + at * edge.length_mm, loop.length);
  return { piece: piece.id, loop: edge.loop, position, point: pointAt(loop, position), snap: null };
}

/** The nearest place on any edge that is no farther than `reach` from a point of the plane; null when there is none. */
export function placeNear({ pieces, offsets }: Around, to: Point, reach: number): LoopPlace | null {
  const near = nearestOf(pieces, offsets, to, null);
  return near && near.far <= reach ? placeOf(near) : null;
}

/** The nearest place on the same loop, however far. */
export function placeAlong({ pieces, offsets }: Around, on: LoopPlace, to: Point): LoopPlace | null {
  const near = nearestOf(pieces.filter(({ id }) => id === on.piece), offsets, to, on.loop);
  return near && placeOf(near);
}

export interface SnapWish {
  /** How far a place may jump, mm. */
  reach: number;
  /** The range begins there and is to be as long as that, so that both sides are equal. */
  equal?: { start: LoopPlace; length: number } | null;
}

/** The place, or what is worth meeting nearby: corners, middles, notches, where something is sewn, the other side's length. */
export function snapped({ pieces, seams }: Around, place: LoopPlace, { reach, equal = null }: SnapWish): LoopPlace {
  const piece = pieces.find(({ id }) => id === place.piece);
  if (!piece || reach <= 0) return place;
  const loop = loopOf(piece, place.loop);
  let best: { position: number; snap: Snap; far: number } | null = null;
  for (const [position, snap] of [...equalEnds(equal), ...marksOf(piece, loop, seams)]) {
    const far = apart(position, place.position, loop.length);
    if (far <= reach && (!best || far < best.far)) best = { position: within(position, loop.length), snap, far };
  }
  return best ? { ...place, position: best.position, point: pointAt(loop, best.position), snap: best.snap } : place;
}

type Mark = [position: number, snap: Snap];

const equalEnds = (equal: SnapWish['equal']): Mark[] =>
  equal && equal.length > kShortest
    ? [
        [equal.start.position + equal.length, 'equal'],
        [equal.start.position - equal.length, 'equal'],
      ]
    : [];

function marksOf(piece: Piece, { edges }: Loop, seams: readonly SeamSides[]): Mark[] {
  const uses = seams.flatMap(({ a, b }) => [...a, ...b]).filter((use) => use.piece === piece.id);
  return edges.flatMap(({ edge, from }): Mark[] => {
    const at = (fraction: number): number => from + fraction * edge.length_mm;
    const sewn = uses
      .filter((use) => use.edge === edge.id)
      .flatMap((use) => [use.from ?? 0, use.to ?? 1])
      .filter((end) => end > 0 && end < 1);
    const notches = piece.notches
      .map((notch) => nearestOn(edge, notch.at))
      .filter((near) => near.distance < 0.5)
      .map((near) => near.at);
    return [
      [from, 'corner'],
      ...sewn.map((end): Mark => [at(end), 'sewn']),
      ...notches.map((notch): Mark => [at(notch), 'notch']),
      [at(0.5), 'middle'],
    ];
  });
}

/** Nothing is drawn yet: the pointer came down here. */
export const begunAt = (start: LoopPlace): RangeDraft => ({ start, end: start, way: 0 });

/**
 * The range once the pointer is at `end`. Of both ways around, the one that goes on from where it was: so a range can be led
 * around the whole outline, and is the shorter way where the pointer jumped.
 */
export function ledTo(piece: Piece, range: RangeDraft, end: LoopPlace): RangeDraft {
  const { length } = loopOf(piece, range.start.loop);
  if (length <= 0) return range;
  const on = within(end.position - range.start.position, length);
  const ways = [on - length, on, on === 0 ? length : on].filter((way) => Math.abs(way) <= length);
  const way = ways.reduce((best, one) => (Math.abs(one - range.way) < Math.abs(best - range.way) ? one : best));
  return { ...range, end, way };
}

/** The edges of a range, in the order and the direction in which it was drawn; none while it is too short. */
export function seriesOf(piece: Piece | undefined, { start, way }: RangeDraft): SeamEdge[] {
  if (!piece || Math.abs(way) < kShortest) return [];
  const loop = loopOf(piece, start.loop);
  const series = forwards(piece.id, loop, way > 0 ? start.position : start.position + way, Math.abs(way));
  return way > 0 ? series : against(series);
}

/** Fractions as fine as this, so that what ends in a corner ends there. */
const fine = (fraction: number): number => Math.round(fraction * 1e6) / 1e6;

function forwards(piece: string, { edges, length }: Loop, from: number, span: number): SeamEdge[] {
  const first = within(from, length);
  // Twice around: a range may begin within the last edge and end within the first.
  return [0, length].flatMap((lap) =>
    edges.flatMap(({ edge, from: at }): SeamEdge[] => {
      const begins = Math.max(first, at + lap);
      const ends = Math.min(first + span, at + lap + edge.length_mm);
      if (ends - begins < 0.01) return [];
      const [a, b] = [begins, ends].map((position) => fine((position - at - lap) / edge.length_mm));
      return [{ piece, edge: edge.id, ...(a! > 0 ? { from: a } : {}), ...(b! < 1 ? { to: b } : {}) }];
    }),
  );
}

/** The same path from its other end. */
const against = (series: readonly SeamEdge[]): SeamEdge[] =>
  series
    .map(({ reversed = false, ...use }): SeamEdge => (reversed ? use : { ...use, reversed: true }))
    .reverse();

/** The draft with a range at the end of the side that is collected: both sides then begin where they were begun. */
export function withSeries(draft: SeamDraft, series: SeamEdge[]): SeamDraft {
  if (series.length === 0) return draft;
  const first = draft.a.length === 0 && draft.b.length === 0;
  return {
    ...draft,
    [draft.side]: [...draft[draft.side], ...series],
    sameDirection: first ? true : draft.sameDirection,
  };
}

/** The same seam with no side that runs against its outlines all along. */
export function tidied({ a, b, sameDirection }: SeamDraft): Pick<SeamDraft, 'a' | 'b' | 'sameDirection'> {
  const turns = (series: SeamEdge[]): boolean => series.length > 0 && series.every((use) => use.reversed);
  const [turnA, turnB] = [turns(a), turns(b)];
  return {
    a: turnA ? against(a) : a,
    b: turnB ? against(b) : b,
    sameDirection: sameDirection !== (turnA !== turnB),
  };
}
