// Seams as the 2D view and its list show them: colours, lengths, which way each side is sewn. Pure.

import type { Piece, PieceEdge, Point, SeamEdge, SeamProposal, SeamSides } from '../api/types';
import { distance } from './outline';
import { cutLine, lengthOf } from './patternGeometry';
import { fixed } from '../texts/numbers';
import { patternFigure, patternLength } from '../texts/units';
import { t } from '../texts/language';

/** How many colours styles/seams.css has. */
export const kSeamColours = 20;

export const seamColour = (index: number): string => `var(--seam-${index % kSeamColours})`;

export type Side = 'a' | 'b';

/** A sewn part of an edge, in its piece's coordinates, in the direction in which the seam is closed. */
export interface SeamPart {
  piece: string;
  edge: string;
  side: Side;
  points: Point[];
}

/** Direction marks: both sides' run the same way along the closed seam. */
export interface SeamMark {
  piece: string;
  at: Point;
  /** Unit vector. */
  along: Point;
}

const edgesOf = (pieces: readonly Piece[]): Map<string, PieceEdge> =>
  new Map(pieces.flatMap((piece) => piece.edges.map((edge) => [`${piece.id}\n${edge.id}`, edge] as const)));

function partsOf(side: Side, series: readonly SeamEdge[], edges: Map<string, PieceEdge>): SeamPart[] {
  return series.flatMap((use): SeamPart[] => {
    const edge = edges.get(`${use.piece}\n${use.edge}`);
    if (!edge) return [];
    const points = cutLine(edge.points, use.from ?? 0, use.to ?? 1);
    return [{ piece: use.piece, edge: use.edge, side, points: use.reversed ? points.reverse() : points }];
  });
}

/** All parts of a seam; edges that the pieces do not have are left away. */
export function seamParts(pieces: readonly Piece[], seam: SeamSides): SeamPart[] {
  const edges = edgesOf(pieces);
  const a = partsOf('a', seam.a, edges);
  const b = partsOf('b', seam.b, edges);
  if (seam.same_direction) return [...a, ...b];
  return [...a, ...b.reverse().map((part) => ({ ...part, points: [...part.points].reverse() }))];
}

/** The place at a fraction of a polyline's length, and its direction there. */
export function alongLine(points: readonly Point[], fraction: number): { at: Point; along: Point } | null {
  const wanted = lengthOf(points) * fraction;
  let gone = 0;
  for (let i = 1; i < points.length; ++i) {
    const [a, b] = [points[i - 1]!, points[i]!];
    const step = distance(a, b);
    if (step > 0 && (gone + step >= wanted || i === points.length - 1)) {
      const t = Math.min(1, (wanted - gone) / step);
      return {
        at: [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])],
        along: [(b[0] - a[0]) / step, (b[1] - a[1]) / step],
      };
    }
    gone += step;
  }
  return null;
}

/** The place at a fraction of a side's whole length, though its parts may lie on several pieces. */
export function alongSide(parts: readonly SeamPart[], fraction: number): Point | null {
  const lengths = parts.map((part) => lengthOf(part.points));
  let wanted = lengths.reduce((sum, length) => sum + length, 0) * fraction;
  for (const [i, part] of parts.entries()) {
    const length = lengths[i]!;
    if (length > 0 && (wanted <= length || i === parts.length - 1)) {
      return alongLine(part.points, Math.min(1, wanted / length))?.at ?? null;
    }
    wanted -= length;
  }
  return null;
}

/** A mark in the middle of each part, three on a long one (`long` mm), none on one that is shorter than a mark. */
export function seamMarks(parts: readonly SeamPart[], long: number): SeamMark[] {
  return parts.flatMap((part) => {
    const length = lengthOf(part.points);
    const places = length > long ? [0.25, 0.5, 0.75] : length > long / 12 ? [0.5] : [];
    return places.flatMap((place): SeamMark[] => {
      const found = alongLine(part.points, place);
      return found ? [{ piece: part.piece, ...found }] : [];
    });
  });
}

/** The point half way along a series of edges; null where the pieces have none of them. */
export const middleOf = (pieces: readonly Piece[], series: readonly SeamEdge[]): Point | null =>
  alongSide(partsOf('a', series, edgesOf(pieces)), 0.5);

/** How long a series of edges is, with the parts of them that are sewn. */
export const lengthOfSeries = (pieces: readonly Piece[], series: readonly SeamEdge[]): number =>
  partsOf('a', series, edgesOf(pieces)).reduce((sum, part) => sum + lengthOf(part.points), 0);

export interface SeamLengths {
  a: number;
  b: number;
  /** Of the longer side over the shorter one, 0 up. */
  ease: number;
}

export function seamLengths(pieces: readonly Piece[], seam: SeamSides): SeamLengths {
  const parts = seamParts(pieces, seam);
  const sum = (side: Side): number =>
    parts.filter((part) => part.side === side).reduce((total, part) => total + lengthOf(part.points), 0);
  const a = sum('a');
  const b = sum('b');
  return { a, b, ease: Math.min(a, b) > 0 ? Math.max(a, b) / Math.min(a, b) - 1 : 0 };
}

/** "412 mm to 398 mm", and how much the difference is. */
export function lengthsText(a: number, b: number): { lengths: string; difference: string } {
  
  const off = Math.abs(a - b);
  const share =
    Math.min(a, b) > 0 ? ` (${fixed((100 * off) / Math.min(a, b), off / Math.min(a, b) < 0.1 ? 1 : 0)} %)` : '';
  return {
    lengths: `${patternFigure(a)} ⇄ ${patternLength(b)}`,
    difference: off < 0.05 ? t.pattern.equal : `${patternLength(off)}${share}`,
  };
}

/** Seams that use an edge, by their number. */
export function seamsOfEdge(seams: readonly SeamSides[], piece: string, edge: string): number[] {
  const uses = (series: readonly SeamEdge[]): boolean => series.some((use) => use.piece === piece && use.edge === edge);
  return seams.flatMap((seam, i) => (uses(seam.a) || uses(seam.b) ? [i] : []));
}

/** Proposals of this confidence are ticked at first. */
export const kSure = 0.8;

/** Whether two seams want the same part of an edge: proposals may be each other's alternatives. */
export function clash(one: SeamSides, other: SeamSides): boolean {
  const uses = [...other.a, ...other.b];
  return [...one.a, ...one.b].some((a) =>
    uses.some(
      (b) =>
        a.piece === b.piece &&
        a.edge === b.edge &&
        Math.min(a.to ?? 1, b.to ?? 1) - Math.max(a.from ?? 0, b.from ?? 0) > 1e-6,
    ),
  );
}

/** Whether a seam holds a piece. */
export const holds = ({ a, b }: SeamSides, piece: string): boolean => [...a, ...b].some((use) => use.piece === piece);

/** Ids of pieces that no seam holds; a piece that is all there is needs none. */
export const unsewn = (pieces: readonly { id: string }[], seams: readonly SeamSides[]): string[] =>
  pieces.length < 2 ? [] : pieces.map(({ id }) => id).filter((id) => !seams.some((seam) => holds(seam, id)));

/** Those with which a garment is best begun, as the service tells. */
export const toWear = (seams: readonly SeamProposal[]): Set<string> =>
  new Set(seams.filter((seam) => seam.to_wear).map((seam) => seam.id));

/** Of proposals, surest first: those of a confidence that can be sewn together. */
export function sewnTogether(seams: readonly SeamProposal[], least: number): Set<string> {
  const taken: SeamProposal[] = [];
  for (const seam of seams) {
    if (seam.confidence >= least && !taken.some((one) => clash(one, seam))) taken.push(seam);
  }
  return new Set(taken.map((seam) => seam.id));
}

/** The ticks after one was set or taken away: one that is set takes the place of those that it clashes with. */
export function ticked(
  seams: readonly SeamSides[],
  chosen: ReadonlySet<string>,
  id: string,
  on: boolean,
): ReadonlySet<string> {
  const next = new Set(chosen);
  next.delete(id);
  const seam = seams.find((one) => one.id === id);
  if (!on || !seam) return next;
  for (const other of seams) if (clash(seam, other)) next.delete(other.id);
  return next.add(id);
}

/** An id that no seam has: seam1, seam2, … */
export function freeSeamId(seams: readonly { id: string }[]): string {
  const used = new Set(seams.map((seam) => seam.id));
  let n = seams.length + 1;
  while (used.has(`seam${n}`)) ++n;
  return `seam${n}`;
}

/** A seam that is being made. */
export interface SeamDraft {
  a: SeamEdge[];
  b: SeamEdge[];
  /** Which side the next click adds to. */
  side: Side;
  /** False for pieces that lie side by side, as they mostly do: outlines run the same way round. */
  sameDirection: boolean;
}

export const emptyDraft: SeamDraft = { a: [], b: [], side: 'a', sameDirection: false };

/** Adds an edge to the side that is collected, or takes it away when it is there. */
export function withEdge(draft: SeamDraft, piece: string, edge: string): SeamDraft {
  const same = (use: SeamEdge): boolean => use.piece === piece && use.edge === edge;
  const other: Side = draft.side === 'a' ? 'b' : 'a';
  if (draft[other].some(same)) return { ...draft, [other]: draft[other].filter((use) => !same(use)) };
  const had = draft[draft.side].some(same);
  const series = had ? draft[draft.side].filter((use) => !same(use)) : [...draft[draft.side], { piece, edge }];
  return { ...draft, [draft.side]: series };
}
