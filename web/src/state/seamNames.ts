// Edges and seams as a pattern maker calls them: by the name that a person gave, else by where they lie on their pieces as
// those are drawn. Pure.

import type { Piece, PieceEdge, Point, SeamEdge, SeamSides } from '../api/types';
import { distance, mix } from './outline';
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
  const titles = toldApart(places.map((at, i) => ({ words: at ? placeWords(at, box) : piece.edges[i]!.id, at })));
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

/** Words for something, and where it lies. */
interface Told {
  words: string;
  at: Point | null;
}

/** The same words are added to by the axis along which two places differ most; more than two are counted. */
function toldApart(all: readonly Told[]): string[] {
  return all.map((one) => {
    const alike = all.filter(({ words }) => words === one.words);
    if (alike.length === 1) return one.words;
    const other = alike.find((each) => each !== one)!;
    const further = alike.length === 2 && one.at && other.at ? furtherWords(one.at, other.at) : '';
    return further ? `${one.words}, ${further}` : `${one.words} (${alike.indexOf(one) + 1})`;
  });
}

function furtherWords([x, y]: Point, [otherX, otherY]: Point): string {
  const { higher, lower, furtherLeft, furtherRight } = t.pattern.apart;
  const [dx, dy] = [x - otherX, y - otherY];
  if (Math.abs(dy) >= Math.abs(dx)) return dy > 0 ? higher : lower;
  return dx > 0 ? furtherRight : furtherLeft;
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

/** "front · right": edges that follow each other on a piece as one, by its name or where its middle lies. */
function sideText(series: readonly SeamEdge[], pieces: readonly Piece[]): string {
  const ids = idsOf(series);
  if (ids.length > kPlaced) return listed(ids);
  return ids.map((id) => runText(id, series.filter((use) => use.piece === id), pieces)).join(' + ');
}

function runText(id: string, run: readonly SeamEdge[], pieces: readonly Piece[]): string {
  const piece = pieceNamed(pieces, id);
  const middle = middleOf(pieces, run);
  const named = run.length === 1 && !kGivenEdge.test(run[0]!.edge);
  if (named || !piece || !middle) return seriesText(run, pieces);
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

/** So far apart are ends that meet at most, mm. */
const kMeeting = 0.1;

/** Where a dart is open, if the seam is one: two edges that go into their piece and out again at a point. */
function mouthOf({ a, b }: SeamSides, pieces: readonly Piece[]): Point | null {
  const [one, other] = [a[0], b[0]];
  if (a.length !== 1 || b.length !== 1 || !one || one.piece !== other?.piece) return null;
  const edges = pieceNamed(pieces, one.piece)?.edges ?? [];
  const [leg, otherLeg] = [one, other].map((use) => edges.find(({ id }) => id === use.edge)?.points ?? []);
  return wedge(leg!, otherLeg!) ?? wedge(otherLeg!, leg!);
}

/** The middle between the outer ends of two legs in the outline's order, counter-clockwise, that meet at a tip in the cloth. */
function wedge(leg: readonly Point[], next: readonly Point[]): Point | null {
  const [from, tip, to] = [leg[0], leg[leg.length - 1], next[next.length - 1]];
  if (!from || !tip || !to || distance(tip, next[0]!) > kMeeting) return null;
  const turn = (tip[0] - from[0]) * (to[1] - tip[1]) - (tip[1] - from[1]) * (to[0] - tip[0]);
  return turn < 0 ? mix(from, to, 0.5) : null;
}

/** A seam by where it lies on each piece that it joins. */
function byPlace(seam: SeamSides, pieces: readonly Piece[]): Told {
  const mouth = mouthOf(seam, pieces);
  const piece = mouth && pieceNamed(pieces, seam.a[0]!.piece);
  if (piece) return { words: t.pattern.dartAt(piece.id, placeWords(mouth, boxOf(piece.outline))), at: mouth };
  return { words: t.pattern.joins(sideText(seam.a, pieces), sideText(seam.b, pieces)), at: middleOf(pieces, seam.a) };
}

/** Whatever is sewn to what. */
const partners = ({ a, b }: SeamSides): string => [...new Set([...idsOf(a), ...idsOf(b)])].sort().join('\n');

/** Seams without names between the same pieces by where they lie on those, all others of the same pieces beside them. */
function seamPlaced(seam: SeamSides, { pieces, seams }: Sewn): string {
  const own = partners(seam);
  const alike = seams.filter((other) => isGivenSeam(other.id) && partners(other) === own);
  const told = toldApart(alike.map((one) => byPlace(one, pieces)));
  return told[alike.findIndex(({ id }) => id === seam.id)] ?? byPlace(seam, pieces).words;
}

/** A seam without its number: its name, or where it lies on the pieces that it joins. */
export const seamWords = (seam: SeamSides, sewn: Sewn): string => (isGivenSeam(seam.id) ? seamPlaced(seam, sewn) : seam.id);

/** No other seam without a name joins the same pieces. */
const isAlone = (seam: SeamSides, seams: readonly SeamSides[]): boolean =>
  seams.every((other) => other.id === seam.id || !isGivenSeam(other.id) || partners(other) !== partners(seam));

/**
 * A seam as a person would call it: its number on the pattern with its name, or with the pieces that it joins, and where on
 * them it lies when other seams join the same.
 */
export function seamTitle(sewn: Sewn, id: string): string {
  const index = sewn.seams.findIndex((seam) => seam.id === id);
  const seam = sewn.seams[index];
  if (!seam) return id;
  const alone = isGivenSeam(id) && isAlone(seam, sewn.seams) && !mouthOf(seam, sewn.pieces);
  return `${index + 1} ${alone ? joins(seam) : seamWords(seam, sewn)}`;
}
