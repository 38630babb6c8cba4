// Flat pieces as the 2D view lays them out: boxes, places, colours of seams. Pure; millimetres, y up.

import type { Piece, Point, Seam } from '../api/types';

export interface Box {
  minX: number;
  minY: number;
  maxX: number;
  maxY: number;
}

export function boxOf(points: readonly Point[]): Box {
  const box = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
  for (const [x, y] of points) {
    box.minX = Math.min(box.minX, x);
    box.minY = Math.min(box.minY, y);
    box.maxX = Math.max(box.maxX, x);
    box.maxY = Math.max(box.maxY, y);
  }
  return box;
}

export function joined(boxes: readonly Box[]): Box {
  return boxOf(
    boxes.flatMap((box): Point[] => [
      [box.minX, box.minY],
      [box.maxX, box.maxY],
    ]),
  );
}

export interface PlacedPiece {
  piece: Piece;
  /** Where the piece is moved to, mm. */
  offset: Point;
  /** After the move. */
  box: Box;
  centre: Point;
}

const moved = (box: Box, [dx, dy]: Point): Box => ({
  minX: box.minX + dx,
  minY: box.minY + dy,
  maxX: box.maxX + dx,
  maxY: box.maxY + dy,
});
const overlap = (a: Box, b: Box): boolean => a.minX < b.maxX && b.minX < a.maxX && a.minY < b.maxY && b.minY < a.maxY;

/** Space between pieces that are laid out anew, mm. */
const kGap = 60;

/**
 * Pieces stay where the pattern has them. Where that would put one on top of another, all are laid in rows instead,
 * tallest first, about as wide as high.
 */
export function layOut(pieces: readonly Piece[]): PlacedPiece[] {
  const boxes = pieces.map((piece) => boxOf(piece.outline));
  const clash = boxes.some((a, i) => boxes.some((b, j) => j > i && overlap(a, b)));
  const offsets = clash ? inRows(boxes) : boxes.map((): Point => [0, 0]);
  return pieces.map((piece, i) => {
    const box = moved(boxes[i]!, offsets[i]!);
    return { piece, offset: offsets[i]!, box, centre: add(insideOf(piece.outline), offsets[i]!) };
  });
}

const add = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1]];

function inRows(boxes: readonly Box[]): Point[] {
  const area = boxes.reduce((sum, b) => sum + (b.maxX - b.minX + kGap) * (b.maxY - b.minY + kGap), 0);
  const width = Math.max(Math.sqrt(area) * 1.15, ...boxes.map((b) => b.maxX - b.minX));
  const order = boxes.map((_, i) => i).sort((a, b) => heightOf(boxes[b]!) - heightOf(boxes[a]!) || a - b);
  const offsets: Point[] = boxes.map(() => [0, 0]);
  let x = 0,
    y = 0,
    row = 0;
  for (const i of order) {
    const box = boxes[i]!;
    const w = box.maxX - box.minX;
    if (x > 0 && x + w > width) {
      y -= row + kGap;
      x = row = 0;
    }
    offsets[i] = [x - box.minX, y - box.maxY];
    x += w + kGap;
    row = Math.max(row, heightOf(box));
  }
  return offsets;
}

const heightOf = (box: Box): number => box.maxY - box.minY;

/** A point inside an outline that is a good place for a label: the middle of the widest span of some level lines. */
export function insideOf(outline: readonly Point[]): Point {
  const box = boxOf(outline);
  let best: Point = [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2];
  let widest = 0;
  for (const level of [0.5, 0.42, 0.58, 0.3, 0.7]) {
    const y = box.minY + level * heightOf(box);
    const cuts = cutsAt(outline, y);
    for (let i = 0; i + 1 < cuts.length; i += 2) {
      const span = cuts[i + 1]! - cuts[i]!;
      if (span > widest * 1.25) {
        widest = span;
        best = [(cuts[i]! + cuts[i + 1]!) / 2, y];
      }
    }
  }
  return best;
}

function cutsAt(outline: readonly Point[], y: number): number[] {
  const cuts: number[] = [];
  outline.forEach(([x0, y0], i) => {
    const [x1, y1] = outline[(i + 1) % outline.length]!;
    if (y0 <= y !== y1 <= y) cuts.push(x0 + ((y - y0) / (y1 - y0)) * (x1 - x0));
  });
  return cuts.sort((a, b) => a - b);
}

/** Hues that keep apart from each other and from the fabric fills, for seams; repeats after twelve. */
const kSeamHues = [212, 28, 152, 330, 268, 92, 190, 8, 48, 292, 122, 240];

export const seamHue = (index: number): number => kSeamHues[index % kSeamHues.length]!;

export interface SeamLine {
  seam: string;
  index: number;
  piece: string;
  side: 'a' | 'b';
  points: Point[];
}

/** Every sewn edge as a line in its piece's coordinates; edges the pieces do not have are left away. */
export function seamLines(pieces: readonly Piece[], seams: readonly Seam[]): SeamLine[] {
  const edges = new Map(
    pieces.flatMap((piece) => piece.edges.map((edge) => [`${piece.id}\n${edge.id}`, edge.points] as const)),
  );
  return seams.flatMap((seam, index) =>
    (['a', 'b'] as const).flatMap((side) =>
      seam[side].flatMap((use): SeamLine[] => {
        const points = edges.get(`${use.piece}\n${use.edge}`);
        return points ? [{ seam: seam.id, index, piece: use.piece, side, points }] : [];
      }),
    ),
  );
}

export function lengthOf(points: readonly Point[]): number {
  let sum = 0;
  for (let i = 1; i < points.length; ++i)
    sum += Math.hypot(points[i]![0] - points[i - 1]![0], points[i]![1] - points[i - 1]![1]);
  return sum;
}

/** Linear RGB as a CSS colour. */
export function cssColour(linear: readonly number[]): string {
  const channel = (c: number): number =>
    Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * Math.max(c, 0) ** (1 / 2.4) - 0.055));
  return `rgb(${linear
    .slice(0, 3)
    .map((c) => Math.min(255, channel(c)))
    .join(' ')})`;
}
