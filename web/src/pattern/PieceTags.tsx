// Names and sizes in full, over all pieces, of those that are pointed at or selected and too small to have them written on.

import type { Piece, Point } from '../api/types';
import { overlap, type PlacedPiece } from '../state/layout';
import { movedBox, widthOf, type Box } from '../state/patternGeometry';
import { nameOn, sizeText, widthOfName } from './PieceShape';

export interface PieceTagsProps {
  placed: readonly PlacedPiece[];
  /** Ids of those that are pointed at or selected. */
  told: readonly (string | null)[];
  scale: number;
  /** The part of the plane that is seen. */
  seen: Box;
}

/** Of a tag, px. */
const kHeight = 20;
const kAway = 6;
/** About the width of a figure. */
const kFigurePx = 6.4;

interface Tag {
  piece: Piece;
  size: string;
  /** mm. */
  box: Box;
}

export function PieceTags({ placed, told, scale, seen }: PieceTagsProps) {
  const small = placed.filter((one) => told.includes(one.piece.id) && nameOn(one, scale) !== one.piece.id);
  return (
    <g class="piece-tags" aria-hidden="true">
      {tagsOf(small, scale, seen).map((tag) => (
        <TagShape key={tag.piece.id} tag={tag} scale={scale} />
      ))}
    </g>
  );
}

/** Halves of a pair lie side by side: one's tag stands above the other's, or below it, rather than on it. */
function tagsOf(placed: readonly PlacedPiece[], scale: number, seen: Box): Tag[] {
  const tags: Tag[] = [];
  for (const { piece, box } of placed) {
    const size = sizeText(piece);
    const wide = (30 + widthOfName(piece.id) + kFigurePx * size.length) / scale;
    const at = tagAt(box, wide, seen, scale);
    let place = tagBox(at, wide, scale);
    const step = (kHeight + 3) / scale;
    const away = place.maxY + step <= seen.maxY ? step : -step;
    while (tags.some((other) => overlap(other.box, place))) place = movedBox(place, [0, away]);
    tags.push({ piece, size, box: place });
  }
  return tags;
}

const tagBox = ([x, y]: Point, wide: number, scale: number): Box => ({
  minX: x - wide / 2,
  maxX: x + wide / 2,
  minY: y - kHeight / 2 / scale,
  maxY: y + kHeight / 2 / scale,
});

function TagShape({ tag: { piece, size, box }, scale }: { tag: Tag; scale: number }) {
  const wide = widthOf(box) * scale;
  return (
    <g class="piece-tag" transform={`translate(${(box.minX + box.maxX) / 2} ${-(box.minY + box.maxY) / 2}) scale(${1 / scale})`}>
      <rect x={-wide / 2} y={-kHeight / 2} width={wide} height={kHeight} rx={6} />
      <text dy="0.35em">
        {piece.id} <tspan>{size}</tspan>
      </text>
    </g>
  );
}

/** The middle of a tag, mm: above its piece or, where that is not to be seen, below it; in all of its breadth, if it can be. */
export function tagAt(box: Box, wide: number, seen: Box, scale: number): Point {
  const away = (kAway + kHeight / 2) / scale;
  const reach = (kHeight / 2) / scale;
  const above = box.maxY + away;
  const y = above + reach <= seen.maxY ? above : Math.max(box.minY - away, seen.minY + reach);
  const x = Math.max(seen.minX + wide / 2, Math.min((box.minX + box.maxX) / 2, seen.maxX - wide / 2));
  return [x, y];
}
