// The seam that is being made: both sides as they are clicked together.

import type { Pieces, SeamEdge } from '../api/types';
import { draftShown } from '../state/editing';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { tidied } from '../state/seamRange';
import { seriesText } from '../state/seamNames';
import { lengthsText, seamColour, seamLengths, type Side } from '../state/seamView';
import { Icon } from '../controls/Icon';
import { NumberField } from '../controls/NumberField';
import { patternLength } from '../texts/units';
import { t } from '../texts/language';

export function SeamDraftPanel({ pieces }: { pieces: Pieces }) {
  const state = useAppState();
  const { seams } = useCommands();
  const { draft } = state.editing;
  const shown = draftShown(state.editing, pieces.pieces);
  const { a, b, side } = shown;
  // Of ranges both sides run as they were drawn: turned is what differs from pieces that lie side by side.
  const turned = tidied(shown).sameDirection;
  const { a: lengthA, b: lengthB } = seamLengths(pieces.pieces, { id: '', a, b });
  const both = a.length > 0 && b.length > 0;
  const { lengths, difference } = lengthsText(lengthA, lengthB);
  return (
    <section class="seam-draft" aria-label={t.pattern.newSeam} style={{ '--seam': seamColour(pieces.seams.length) }}>
      <h3>{t.pattern.newSeam}</h3>
      {(['a', 'b'] as const).map((one) => (
        <button
          key={one}
          class="draft-side"
          aria-pressed={side === one}
          onClick={() => (draft.value = { ...draft.value, side: one })}
        >
          <em>{one.toUpperCase()}</em>
          <span>{shown[one].length > 0 ? seriesText(shown[one], pieces.pieces) : t.pattern.clickEdges}</span>
          <small>{shown[one].length > 0 ? patternLength(one === 'a' ? lengthA : lengthB) : ''}</small>
        </button>
      ))}
      <DraftEdges side={side} pieces={pieces} />
      {both && (
        <p>
          {lengths} · <b>{difference}</b>
        </p>
      )}
      <div class="button-row">
        <button class="primary" disabled={!both} onClick={() => void seams.addSeam()}>
          {t.common.sew}
        </button>
        <button class="plain" disabled={!both} aria-pressed={turned} onClick={() => seams.turnDraft()}>
          {t.pattern.reverse}
        </button>
        <button class="plain" onClick={() => seams.clearDraft()}>
          {t.pattern.clear}
        </button>
      </div>
    </section>
  );
}

/** Edges of the side that is collected, each with the part of it that is sewn. */
function DraftEdges({ side, pieces }: { side: Side; pieces: Pieces }) {
  const state = useAppState();
  const { seams } = useCommands();
  const series = state.editing.draft.value[side];
  const whole = ({ piece, edge }: SeamEdge): string => seriesText([{ piece, edge }], pieces.pieces);
  if (series.length === 0) return null;
  return (
    <ul class="draft-edges" aria-label={t.pattern.edgesOfSide(side.toUpperCase())}>
      {series.map((use, i) => (
        <li key={`${i} ${use.piece} ${use.edge}`}>
          <span>{whole(use)}</span>
          <RangeFields use={use} {...{ pieces }} take={(from, to) => seams.cutDraft(side, i, from, to)} />
          <button
            class="tool flat"
            aria-label={t.pattern.leaveOut(whole(use))}
            onClick={() => seams.leaveOut(side, i)}
          >
            <Icon name="cross" />
          </button>
        </li>
      ))}
    </ul>
  );
}

interface RangeFieldsProps {
  use: SeamEdge;
  pieces: Pieces;
  /** Fractions of the edge's length. */
  take(from: number, to: number): void;
}

/** Where on its edge it begins and ends, from the edge's start. */
function RangeFields({ use, pieces, take }: RangeFieldsProps) {
  const piece = pieces.pieces.find(({ id }) => id === use.piece);
  const length = piece?.edges.find(({ id }) => id === use.edge)?.length_mm ?? 0;
  if (length <= 0) return null;
  const { from = 0, to = 1 } = use;
  return (
    <>
      <NumberField label={t.pattern.from} length value={from * length} take={(mm) => take(mm / length, to)} />
      <NumberField label={t.pattern.to} length value={to * length} take={(mm) => take(from, mm / length)} />
    </>
  );
}
