// Sews parts of edges together: a range is drawn along an outline, by two clicks or a drag, and another to meet it.

import { loading, valueOf, type AppState } from '../state/AppState';
import { toCorners } from '../state/seamRange';
import type { PatternTool, Spot } from './PatternTool';
import { sewByKeys, sewing } from './sewing';
import type { PlaneSpot } from '../commands/RangeCommands';
import { t } from '../texts/language';
import { patternFigure, patternLength } from '../texts/units';

/** An edge is caught from twice as far as a place jumps. */
const planeSpot = ({ at, way }: Spot): PlaneSpot => ({ at, catches: 2 * way.reach, reach: way.alt ? 0 : way.reach });

export const range: PatternTool = {
  ...sewing,
  id: 'range',
  words: () => t.keys.tools.range,
  key: 'M',
  // The pointer's presses are the trace's; keys take whole edges, whose parts are typed.
  edges: { tabbed: 'all', press: (hand, at, key) => key !== null && sewByKeys(hand, at, key) },
  trace: {
    move: ({ commands }, spot) => commands.ranges.point(spot && planeSpot(spot)),
    press: ({ commands }, spot) => commands.ranges.press(planeSpot(spot), spot.way.shift),
    release: ({ commands }, spot) => commands.ranges.release(planeSpot(spot), spot.way.shift),
  },
  say: (state) => {
    const { draft, range: drawn } = state.editing;
    if (drawn.value) return t.keys.rangeEnd;
    const place = placeWords(state);
    return (
      <>
        {draft.value.a.length > 0 ? t.keys.rangeOther : t.keys.rangeOne}
        {place && (
          <>
            {' · '}
            <b>{place}</b>
          </>
        )}
      </>
    );
  },
};

/** How far the place under the pointer is from the corners on both sides, and what it has met. */
function placeWords({ editing, pieces }: AppState) {
  const place = editing.place.value;
  const piece = valueOf(pieces.value ?? loading)?.pieces.find(({ id }) => id === place?.piece);
  if (!place || !piece) return null;
  const { before, behind } = toCorners(piece, place);
  const met = place.snap ? `, ${t.pattern.snaps[place.snap]}` : '';
  return `${patternFigure(before)} | ${patternLength(behind)}${met}`;
}
