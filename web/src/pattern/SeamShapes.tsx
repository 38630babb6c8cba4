// The seams over the pieces: each in a colour of its own on both sides, with marks that run the way it is closed; threads
// between the sides of the one that is lit.

import type { Point, SeamSides } from '../api/types';
import type { PlacedPiece } from '../state/layout';
import { alongLine, alongSide, seamColour, seamMarks, type SeamPart } from '../state/seamView';
import { linePath } from './PieceShape';

/** Id of the seam that is being made, among those that are shown. */
export const kDraftSeam = 'new';

export interface ShownSeam {
  seam: SeamSides;
  index: number;
  parts: SeamPart[];
}

export interface SeamShapesProps {
  shown: ShownSeam[];
  piece: string;
  scale: number;
  lit: string | null;
  onLight(seam: string | null): void;
  /** Null where a press is for what lies under the seam. */
  onSelect: ((seam: string) => void) | null;
}

/** The parts of all seams that lie on one piece, in its coordinates. */
export function SeamShapes({ shown, piece, scale, lit, onLight, onSelect }: SeamShapesProps) {
  return (
    <>
      {shown.map(({ seam, index, parts }) => {
        const here = parts.filter((part) => part.piece === piece);
        if (here.length === 0) return null;
        const on = lit === seam.id;
        return (
          <g
            key={seam.id}
            class={`seam${on ? ' lit' : lit ? ' dim' : ''}`}
            style={{ '--seam': seamColour(index) }}
            data-seam={seam.id}
            onPointerEnter={() => onLight(seam.id)}
            onPointerLeave={() => onLight(null)}
            onPointerDown={(event) => {
              if (!onSelect || event.button !== 0) return;
              event.stopPropagation();
              onSelect(seam.id);
            }}
          >
            {here.map((part, i) => (
              <g key={i}>
                <path class="seam-catch" d={linePath(part.points)} />
                <path class="seam-line" d={linePath(part.points)} />
              </g>
            ))}
            {seamMarks(here, 260 / scale).map((mark, i) => (
              <Chevron key={i} at={mark.at} along={mark.along} scale={scale} />
            ))}
          </g>
        );
      })}
    </>
  );
}

function Chevron({ at, along, scale }: { at: Point; along: Point; scale: number }) {
  const degrees = (Math.atan2(-along[1], along[0]) * 180) / Math.PI;
  return (
    <path
      class="seam-mark"
      d="M-3.2 -4.2L3.2 0L-3.2 4.2"
      transform={`translate(${at[0]} ${-at[1]}) rotate(${degrees}) scale(${1 / scale})`}
    />
  );
}

/** The seam's number and side, so that no seam is told by its colour alone. */
function Badge({ part, number, scale }: { part: SeamPart; number: number; scale: number }) {
  const place = alongLine(part.points, 0.5);
  if (!place) return null;
  const text = `${number}${part.side.toUpperCase()}`;
  const wide = 8 + 7 * text.length;
  return (
    <g class="seam-badge" transform={`translate(${place.at[0]} ${-place.at[1]}) scale(${1 / scale})`}>
      <rect x={-wide / 2} y={-8} width={wide} height={16} rx={8} />
      <text dy="0.35em">{text}</text>
    </g>
  );
}

/** Dashed threads between both sides and the numbers on them, over everything, in the plane's coordinates. */
export function Threads({ shown, placed, scale }: { shown: ShownSeam; placed: readonly PlacedPiece[]; scale: number }) {
  const offsets = new Map(placed.map((piece) => [piece.piece.id, piece.offset]));
  const parts = shown.parts.map((part): SeamPart => {
    const [dx, dy] = offsets.get(part.piece) ?? [0, 0];
    return { ...part, points: part.points.map(([x, y]): Point => [x + dx, y + dy]) };
  });
  const side = (which: 'a' | 'b'): SeamPart[] => parts.filter((part) => part.side === which);
  const places = [0, 0.25, 0.5, 0.75, 1];
  const ends = places.map((place) => [alongSide(side('a'), place), alongSide(side('b'), place)] as const);
  return (
    <g class="threads" style={{ '--seam': seamColour(shown.index) }} aria-hidden="true">
      {ends.map(([from, to], i) => (from && to ? <path key={i} d={linePath([from, to])} /> : null))}
      {parts.map((part, i) => (
        <Badge key={`badge ${i}`} part={part} number={shown.index + 1} scale={scale} />
      ))}
    </g>
  );
}
