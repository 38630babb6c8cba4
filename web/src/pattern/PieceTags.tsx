// Names and sizes in full, over all pieces, of those that are pointed at or selected and too small to have them written on.

import type { Point } from '../api/types';
import type { PlacedPiece } from '../state/layout';
import type { Box } from '../state/patternGeometry';
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

export function PieceTags({ placed, told, scale, seen }: PieceTagsProps) {
  const small = placed.filter((one) => told.includes(one.piece.id) && nameOn(one, scale) !== one.piece.id);
  return (
    <g class="piece-tags" aria-hidden="true">
      {small.map((one) => (
        <Tag key={one.piece.id} placed={one} scale={scale} seen={seen} />
      ))}
    </g>
  );
}

function Tag({ placed: { piece, box }, scale, seen }: { placed: PlacedPiece; scale: number; seen: Box }) {
  const size = sizeText(piece);
  const wide = 22 + widthOfName(piece.id) + kFigurePx * size.length;
  const [x, y] = tagAt(box, wide / scale, seen, scale);
  return (
    <g class="piece-tag" transform={`translate(${x} ${-y}) scale(${1 / scale})`}>
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
