// Edges and seams as a pattern maker calls them: by the name that a person gave, else by where they lie on their pieces as
// those are drawn. Pure.

import type { Piece, PieceEdge, Point, SeamEdge, SeamSides } from '../api/types';
import { boxOf, type Box } from './patternGeometry';
import { alongLine, middleOf } from './seamView';
import { t } from '../texts/language';

/** Ids that the service gave edges, not a person. */
const kGivenEdge = /^(e|edge)?\d+$/;
/** Ids that the service or the page gave seams. */
const kGivenSeam = /^(seam|s)?\d+$/;
export const isGivenSeam = (id: string): boolean => kGivenSeam.test(id);

/** Pieces with their seams, in the order of their numbers. */
export interface Sewn {
  pieces: readonly Piece[];
  seams: readonly SeamSides[];
}

// ---- edges

/** An edge as a person would call it: its name, or where its middle lies on the piece as it is drawn. */
export function edgeWords(piece: Piece | undefined, id: string): string {
  return (piece && edgeTitles(piece).get(id)) ?? id;
}

/** Of all edges of a piece; those that lie at the same place are told apart by which lies further out. */
export function edgeTitles(piece: Piece): ReadonlyMap<string, string> {
  const box = boxOf(piece.outline);
  const places = piece.edges.map((edge) => (kGivenEdge.test(edge.id) ? middleOfEdge(edge) : null));
  const words = places.map((place, i) => (place ? placeWords(place, box) : piece.edges[i]!.id));
  const titles = words.map((word, i) => {
    const alike = words.flatMap((other, k) => (other === word ? [k] : []));
    const more = moreWords(alike.map((k) => places[k] ?? null));
    return alike.length > 1 ? more(word, alike.indexOf(i)) : word;
  });
  return new Map(piece.edges.map((edge, i) => [edge.id, titles[i]!]));
}

const middleOfEdge = (edge: PieceEdge): Point | null => alongLine(edge.points, 0.5)?.at ?? edge.points[0] ?? null;

/** Of half a piece's breadth or height: what lies further out is at that side. */
const kAside = 0.45;

/** "top left": where a point lies on a piece that fills this box. */
function placeWords([x, y]: Point, { minX, maxX, minY, maxY }: Box): string {
  const { top, bottom, left, right, middle } = t.pattern.sides;
  const words = [aside(y, minY, maxY, bottom, top), aside(x, minX, maxX, left, right)];
  return words.filter(Boolean).join(' ') || middle;
}

/** Which end of a range a value is near; empty: neither. */
function aside(value: number, from: number, to: number, low: string, high: string): string {
  const place = (2 * (value - from)) / Math.max(to - from, 1e-9) - 1;
  if (Math.abs(place) <= kAside) return '';
  return place > 0 ? high : low;
}

/** What to add to a word that two places share, along the axis that they differ by most; more than two are counted. */
function moreWords(places: readonly (Point | null)[]): (word: string, index: number) => string {
  const [one, other] = places;
  if (places.length !== 2 || !one || !other) return (word, i) => `${word} (${i + 1})`;
  const { higher, lower, furtherLeft, furtherRight } = t.pattern.apart;
  const [dx, dy] = [other[0] - one[0], other[1] - one[1]];
  const upright = Math.abs(dy) >= Math.abs(dx);
  const [low, high] = upright ? [lower, higher] : [furtherLeft, furtherRight];
  const rising = (upright ? dy : dx) > 0;
  return (word, i) => `${word}, ${rising === (i === 1) ? high : low}`;
}

// ---- sides of a seam

const partText = ({ from = 0, to = 1 }: SeamEdge): string =>
  from > 0 || to < 1 ? ` (${Math.round(100 * from)}–${Math.round(100 * to)} %)` : '';

const pieceNamed = (pieces: readonly Piece[], id: string): Piece | undefined => pieces.find((piece) => piece.id === id);

/** "front · waist + back · right": edge by edge. */
export const seriesText = (series: readonly SeamEdge[], pieces: readonly Piece[] = []): string =>
  series.map((use) => `${use.piece} · ${edgeWords(pieceNamed(pieces, use.piece), use.edge)}${partText(use)}`).join(' + ');

/** So many pieces of a side can be told with a place on each. */
const kPlaced = 2;

/** "front · right": edges that follow each other on a piece as one. */
function sideText(series: readonly SeamEdge[], pieces: readonly Piece[]): string {
  const ids = idsOf(series);
  if (ids.length > kPlaced) return listed(ids);
  return ids.map((id) => runText(id, series.filter((use) => use.piece === id), pieces)).join(' + ');
}

function runText(id: string, run: readonly SeamEdge[], pieces: readonly Piece[]): string {
  const piece = pieceNamed(pieces, id);
  const middle = middleOf(pieces, run);
  if (run.length === 1 || !piece || !middle) return seriesText(run, pieces);
  return `${id} · ${placeWords(middle, boxOf(piece.outline))}`;
}

// ---- seams

const idsOf = (series: readonly SeamEdge[]): string[] => [...new Set(series.map((use) => use.piece))];
const listed = (ids: readonly string[]): string => ids.join(` ${t.pattern.and} `);

/** "front to back and back_mirrored": the pieces that a seam joins, each once. */
function joins({ a, b }: SeamSides): string {
  const [from, to] = [listed(idsOf(a)), listed(idsOf(b))];
  return from === to ? t.pattern.toItself(from) : t.pattern.joins(from, to);
}

/** A seam by where it lies on each piece that it joins. */
const byPlace = ({ a, b }: SeamSides, pieces: readonly Piece[]): string =>
  t.pattern.joins(sideText(a, pieces), sideText(b, pieces));

/** A seam without its number: its name, or the edges that it joins. */
export const seamWords = (seam: SeamSides, pieces: readonly Piece[]): string =>
  isGivenSeam(seam.id) ? byPlace(seam, pieces) : seam.id;

/** Whatever is sewn to what. */
const partners = ({ a, b }: SeamSides): string => [...new Set([...idsOf(a), ...idsOf(b)])].sort().join('\n');

/** Of seams with the same partners, all without names. */
function isAlike(seam: SeamSides, seams: readonly SeamSides[]): boolean {
  const own = partners(seam);
  return seams.filter((other) => isGivenSeam(other.id) && partners(other) === own).length > 1;
}

/**
 * A seam as a person would call it: its number on the pattern with its name, or with the pieces that it joins, and where on
 * them it lies when other seams join the same.
 */
export function seamTitle({ pieces, seams }: Sewn, id: string): string {
  const index = seams.findIndex((seam) => seam.id === id);
  const seam = seams[index];
  if (!seam) return id;
  const words = isGivenSeam(id) && !isAlike(seam, seams) ? joins(seam) : seamWords(seam, pieces);
  return `${index + 1} ${words}`;
}
