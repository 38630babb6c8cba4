// Where a range begins and ends that is drawn along an outline: a dot at the place under the pointer, with how long the
// range is, or what it has met.

import { useAppState } from '../state/context';
import type { Point } from '../api/types';
import { add } from '../state/outline';
import type { PlacedPiece } from '../state/layout';
import { seamColour } from '../state/seamView';
import type { LoopPlace } from '../state/seamRange';
import { t } from '../texts/language';
import { patternLength } from '../texts/units';

export interface RangeMarksProps {
  placed: readonly PlacedPiece[];
  scale: number;
  /** How many seams there are: the new one has the next colour. */
  colour: number;
}

/** Width of a letter on the chip, px. */
const kLetterPx = 6.9;

export function RangeMarks({ placed, scale, colour }: RangeMarksProps) {
  const { range, place } = useAppState().editing;
  const drawn = range.value;
  const spot = place.value ?? drawn?.end ?? null;
  if (!spot) return null;
  const at = (one: LoopPlace): Point => add(one.point, placed.find(({ piece }) => piece.id === one.piece)?.offset ?? [0, 0]);
  const met = spot.snap ? t.pattern.snaps[spot.snap] : '';
  const words = [drawn ? patternLength(Math.abs(drawn.way)) : '', met].filter(Boolean).join(', ');
  return (
    <g class="range-marks" style={{ '--seam': seamColour(colour) }} aria-hidden="true">
      {drawn && <Dot at={at(drawn.start)} scale={scale} snapped={drawn.start.snap !== null} />}
      <Dot at={at(spot)} scale={scale} snapped={spot.snap !== null} />
      {words !== '' && <Chip at={at(spot)} scale={scale} words={words} />}
    </g>
  );
}

/** A square where it has met something, as corners are, else a circle. */
function Dot({ at: [x, y], scale, snapped }: { at: Point; scale: number; snapped: boolean }) {
  const transform = `translate(${x} ${-y}) scale(${1 / scale})`;
  if (snapped) return <rect class="range-dot" transform={transform} x={-5} y={-5} width={10} height={10} rx={1.5} />;
  return <circle class="range-dot" transform={transform} r={5} />;
}

function Chip({ at: [x, y], scale, words }: { at: Point; scale: number; words: string }) {
  const wide = 12 + kLetterPx * words.length;
  return (
    <g class="range-chip" transform={`translate(${x} ${-y}) scale(${1 / scale}) translate(0 -22)`}>
      <rect x={-wide / 2} y={-10} width={wide} height={20} rx={6} />
      <text dy="0.35em">{words}</text>
    </g>
  );
}
