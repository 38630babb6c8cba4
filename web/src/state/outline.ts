// Outlines as chains of cubic curves: what a hand on the 2D view needs of them. Pure; millimetres, y up. The service does
// the edits; what is here shows them while the pointer moves, by the same rules.

import type { Curve, Piece, PieceEdge, Point } from '../api/types';

export const add = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1]];
export const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1]];
export const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
export const mix = (a: Point, b: Point, t: number): Point => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];

export function curveAt([p0, p1, p2, p3]: Curve, t: number): Point {
  const a = mix(p0, p1, t);
  const b = mix(p1, p2, t);
  const c = mix(p2, p3, t);
  return mix(mix(a, b, t), mix(b, c, t), t);
}

/** Straight as the service draws a line: with its handles at the thirds. */
export function isStraight([p0, p1, p2, p3]: Curve): boolean {
  const slack = 0.01 + 1e-4 * distance(p0, p3);
  return distance(p1, mix(p0, p3, 1 / 3)) < slack && distance(p2, mix(p0, p3, 2 / 3)) < slack;
}

export const straight = (a: Point, b: Point): Curve => [a, mix(a, b, 1 / 3), mix(a, b, 2 / 3), b];

/** Joints of an edge's curves: number 0 is its start, the last its end. */
export const jointsOf = (edge: PieceEdge): Point[] =>
  edge.curves.length === 0 ? [] : [edge.curves[0]![0], ...edge.curves.map((curve) => curve[3])];

const number = (value: number): string => String(Math.round(value * 1000) / 1000);

/** SVG path through curves; y down, as SVG has it. */
export function pathOf(curves: readonly Curve[], closed: boolean): string {
  if (curves.length === 0) return '';
  const at = ([x, y]: Point): string => `${number(x)} ${number(-y)}`;
  const parts = curves.map((curve) =>
    isStraight(curve) ? `L${at(curve[3])}` : `C${at(curve[1])} ${at(curve[2])} ${at(curve[3])}`,
  );
  return `M${at(curves[0]![0])}${parts.join('')}${closed ? 'Z' : ''}`;
}

const polygon = (points: readonly Point[]): string =>
  points.length === 0 ? '' : `M${points.map(([x, y]) => `${number(x)} ${number(-y)}`).join('L')}Z`;

/** Outline and holes of a piece as one path: along its curves, or its points where only those are known. */
export function piecePath(piece: Piece): string {
  if (piece.edges.every((edge) => edge.curves.length === 0))
    return [piece.outline, ...piece.holes].map(polygon).join('');
  const loops = new Map<number, Curve[]>();
  for (const edge of piece.edges) loops.set(edge.loop, [...(loops.get(edge.loop) ?? []), ...edge.curves]);
  return [...loops.values()].map((curves) => pathOf(curves, true)).join('');
}

const kSteps = 24;

/** Points along an edge with their distance from its start, close enough for lengths to 0.1 %. */
function walk(curves: readonly Curve[]): { at: Point; length: number }[] {
  const steps: { at: Point; length: number }[] = [];
  for (const curve of curves) {
    const count = isStraight(curve) ? 1 : kSteps;
    for (let i = steps.length === 0 ? 0 : 1; i <= count; ++i) {
      const at = curveAt(curve, i / count);
      const last = steps[steps.length - 1];
      steps.push({ at, length: last ? last.length + distance(last.at, at) : 0 });
    }
  }
  return steps;
}

export const lengthOfCurves = (curves: readonly Curve[]): number => walk(curves).at(-1)?.length ?? 0;

export interface Nearest {
  point: Point;
  /** Fraction of the edge's length. */
  at: number;
  distance: number;
}

/** The place of an edge nearest to a point. */
export function nearestOn(edge: PieceEdge, to: Point): Nearest {
  const steps = walk(edge.curves);
  const whole = steps.at(-1)?.length || 1;
  let best: Nearest = { point: steps[0]?.at ?? [0, 0], at: 0, distance: Infinity };
  for (let i = 1; i < steps.length; ++i) {
    const a = steps[i - 1]!;
    const b = steps[i]!;
    const along = minus(b.at, a.at);
    const square = along[0] ** 2 + along[1] ** 2 || 1;
    const t = Math.min(1, Math.max(0, ((to[0] - a.at[0]) * along[0] + (to[1] - a.at[1]) * along[1]) / square));
    const point = mix(a.at, b.at, t);
    const far = distance(point, to);
    if (far < best.distance) best = { point, at: (a.length + t * (b.length - a.length)) / whole, distance: far };
  }
  return best;
}

/** The point as far along the nearest multiple of 45° from `from`. */
export function snapped45(from: Point, to: Point): Point {
  const [dx, dy] = minus(to, from);
  const eighth = Math.round(Math.atan2(dy, dx) / (Math.PI / 4));
  const [ux, uy] = [Math.cos((eighth * Math.PI) / 4), Math.sin((eighth * Math.PI) / 4)];
  const far = dx * ux + dy * uy;
  return [from[0] + far * ux, from[1] + far * uy];
}

/** Puts x or y onto that of another point which is within `reach`; says which points it took. */
export function aligned(to: Point, others: readonly Point[], reach: number): { at: Point; guides: Point[] } {
  const at: Point = [...to];
  const guides: Point[] = [];
  for (const axis of [0, 1] as const) {
    let best: Point | null = null;
    for (const other of others) {
      const off = Math.abs(other[axis] - to[axis]);
      if (off <= reach && (!best || off < Math.abs(best[axis] - to[axis]))) best = other;
    }
    if (best) {
      at[axis] = best[axis];
      guides.push(best);
    }
  }
  return { at, guides };
}

// ---- edits as they will come out, while the pointer moves: proto/fixtures/edits holds them to what the service does

const edited = (piece: Piece, curves: (edge: PieceEdge) => Curve[]): Piece => {
  const edges = piece.edges.map((edge) => {
    const now = curves(edge);
    if (now === edge.curves) return edge;
    return { ...edge, curves: now, points: walk(now).map((step) => step.at), length_mm: lengthOfCurves(now) };
  });
  const outline = edges.filter((edge) => edge.loop === 0).flatMap((edge) => edge.points.slice(0, -1));
  return { ...piece, edges, outline };
};

/** How far off its line a handle may lie, mm, so that the service keeps the curve straight. */
const kOffLine = 1e-6;

/**
 * Whether the service keeps a curve straight when an end of it moves: its handles lie on the line between its ends, in
 * their order. isStraight is the person's idea of it, and asks for the thirds but is not so strict.
 */
function staysStraight([p0, p1, p2, p3]: Curve): boolean {
  const [dx, dy] = minus(p3, p0);
  const length = Math.hypot(dx, dy);
  const along = (p: Point): number => ((p[0] - p0[0]) * dx + (p[1] - p0[1]) * dy) / length;
  const off = (p: Point): number => Math.abs((p[0] - p0[0]) * dy - (p[1] - p0[1]) * dx) / length;
  const inOrder = along(p1) >= 0 && along(p2) >= along(p1) && along(p2) <= length;
  return inOrder && off(p1) <= kOffLine && off(p2) <= kOffLine;
}

/** Both ends of a curve that are at `was` go to `to` with their handles; a straight curve stays straight. */
function withEndsMoved(curve: Curve, was: Point, by: Point): Curve {
  const first = distance(curve[0], was) < 1e-3;
  const last = distance(curve[3], was) < 1e-3;
  if (!first && !last) return curve;
  const p0 = first ? add(curve[0], by) : curve[0];
  const p3 = last ? add(curve[3], by) : curve[3];
  if (staysStraight(curve)) return straight(p0, p3);
  return [p0, first ? add(curve[1], by) : curve[1], last ? add(curve[2], by) : curve[2], p3];
}

/** The piece with a joint of an edge elsewhere: as the edit move_point does it. */
export function withPointMoved(piece: Piece, edgeId: string, point: number, to: Point): Piece {
  const moved = piece.edges.find((edge) => edge.id === edgeId);
  const was = moved && jointsOf(moved)[point];
  if (!moved || !was) return piece;
  const by = minus(to, was);
  return edited(piece, (edge) => {
    if (edge.loop !== moved.loop) return edge.curves;
    const curves = edge.curves.map((curve) => withEndsMoved(curve, was, by));
    return curves.some((curve, i) => curve !== edge.curves[i]) ? curves : edge.curves;
  });
}

/** The piece with a handle elsewhere: as the edit move_handle does it. */
export function withHandleMoved(piece: Piece, edgeId: string, curve: number, handle: 1 | 2, to: Point): Piece {
  return edited(piece, (edge) => {
    if (edge.id !== edgeId) return edge.curves;
    return edge.curves.map((old, i): Curve => {
      if (i !== curve) return old;
      return handle === 1 ? [old[0], to, old[2], old[3]] : [old[0], old[1], to, old[3]];
    });
  });
}

/** Which notch of the piece lies at a point of its outline; -1 for none. */
export const notchAt = (piece: Piece, at: Point): number =>
  piece.notches.findIndex((notch) => distance(notch.at, at) < 0.1);

/** Handles that bend a straight curve outwards by a tenth of its length, for bend_edge. */
export function bentHandles([p0, , , p3]: Curve): [Point, Point] {
  const [dx, dy] = minus(p3, p0);
  const out: Point = [dy * 0.13, -dx * 0.13];
  return [add(mix(p0, p3, 1 / 3), out), add(mix(p0, p3, 2 / 3), out)];
}

/** The edge that follows in its loop; null when the edge is a loop by itself. */
export function nextEdge(piece: Piece, edgeId: string): PieceEdge | null {
  const edge = piece.edges.find((one) => one.id === edgeId);
  if (!edge) return null;
  const loop = piece.edges.filter((one) => one.loop === edge.loop);
  const next = loop[(loop.indexOf(edge) + 1) % loop.length]!;
  return next === edge ? null : next;
}
