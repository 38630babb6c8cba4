// Where the 2D view puts the pieces. Pure; millimetres, y up.

import type { Piece, Point } from '../api/types';
import { add } from './outline';
import { packed, scaleIn, type Room } from './packing';
import { boxOf, insideOf, joined, movedBox, type Box } from './patternGeometry';

export interface PlacedPiece {
  piece: Piece;
  /** Where the piece is moved to, mm. */
  offset: Point;
  /** After the move. */
  box: Box;
  centre: Point;
}

export const overlap = (a: Box, b: Box): boolean => a.minX < b.maxX && b.minX < a.maxX && a.minY < b.maxY && b.minY < a.maxY;

/** Space between pieces that are laid out anew, mm. */
const kGap = 50;
/** A pattern's own places are left when pieces would be seen so much smaller there than they could be. */
const kWorth = 0.6;

/**
 * Pieces stay where the pattern has them. Where that would put one on top of another, or so far apart that they could
 * hardly be seen in the room that there is, they are packed for that room instead. Pieces in `kept` stay where they were
 * shown; others come beside them when they would lie on one.
 */
export function layOut(pieces: readonly Piece[], room: Room, kept: ReadonlyMap<string, Point> = new Map()): PlacedPiece[] {
  const boxes = pieces.map((piece) => boxOf(piece.outline));
  const anyKept = pieces.some((piece) => kept.has(piece.id));
  const offsets = anyKept ? besideKept(pieces, boxes, kept) : laidAnew(boxes, room);
  return pieces.map((piece, i) => {
    const box = movedBox(boxes[i]!, offsets[i]!);
    return { piece, offset: offsets[i]!, box, centre: add(insideOf(piece.outline), offsets[i]!) };
  });
}

function laidAnew(boxes: readonly Box[], room: Room): Point[] {
  const own = boxes.map((): Point => [0, 0]);
  if (boxes.length < 2) return own;
  const offsets = packed(boxes, room, kGap);
  const spread = scaleIn(boxes, room) < kWorth * scaleIn(boxes.map((box, i) => movedBox(box, offsets[i]!)), room);
  return clash(boxes) || spread ? offsets : own;
}

const clash = (boxes: readonly Box[]): boolean => boxes.some((a, i) => boxes.some((b, j) => j > i && overlap(a, b)));

function besideKept(pieces: readonly Piece[], boxes: readonly Box[], kept: ReadonlyMap<string, Point>): Point[] {
  const places = boxes.flatMap((box, i) => {
    const offset = kept.get(pieces[i]!.id);
    return offset ? [movedBox(box, offset)] : [];
  });
  return boxes.map((box, i): Point => {
    const offset = kept.get(pieces[i]!.id);
    if (offset) return offset;
    const free = places.every((place) => !overlap(place, box));
    const right = joined(places);
    const found: Point = free ? [0, 0] : [right.maxX + kGap - box.minX, right.maxY - box.maxY];
    places.push(movedBox(box, found));
    return found;
  });
}
