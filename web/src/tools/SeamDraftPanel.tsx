// The seam that is being made: both sides as they are clicked together.

import type { Pieces } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { lengthsText, seamColour, seamLengths, seriesText, type Side } from '../state/seamView';
import { Icon } from '../controls/Icon';
import { NumberField } from '../controls/NumberField';
import { patternLength } from '../texts/units';
import { t } from '../texts/language';

export function SeamDraftPanel({ pieces }: { pieces: Pieces }) {
  const state = useAppState();
  const { pattern } = useCommands();
  const { draft } = state.editing;
  const { a, b, side, sameDirection } = draft.value;
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
          <span>{draft.value[one].length > 0 ? seriesText(draft.value[one], pieces.pieces) : t.pattern.clickEdges}</span>
          <small>{draft.value[one].length > 0 ? patternLength(one === 'a' ? lengthA : lengthB) : ''}</small>
        </button>
      ))}
      <DraftEdges side={side} />
      {both && (
        <p>
          {lengths} · <b>{difference}</b>
        </p>
      )}
      <div class="button-row">
        <button class="primary" disabled={!both} onClick={() => void pattern.addSeam()}>
          {t.common.sew}
        </button>
        <button class="plain" disabled={!both} aria-pressed={sameDirection} onClick={() => pattern.turnDraft()}>
          {t.pattern.reverse}
        </button>
        <button class="plain" onClick={() => pattern.clearDraft()}>
          {t.pattern.clear}
        </button>
      </div>
    </section>
  );
}

/** Edges of the side that is collected, each with the part of it that is sewn. */
function DraftEdges({ side }: { side: Side }) {
  const state = useAppState();
  const { pattern } = useCommands();
  const series = state.editing.draft.value[side];
  if (series.length === 0) return null;
  return (
    <ul class="draft-edges" aria-label={t.pattern.edgesOfSide(side.toUpperCase())}>
      {series.map((use, i) => (
        <li key={`${use.piece} ${use.edge}`}>
          <span>
            {use.piece} · {use.edge}
          </span>
          <NumberField
            label={t.pattern.from}
            unit="%"
            value={100 * (use.from ?? 0)}
            take={(from) => pattern.cutDraft(side, i, from / 100, use.to ?? 1)}
          />
          <NumberField
            label={t.pattern.to}
            unit="%"
            value={100 * (use.to ?? 1)}
            take={(to) => pattern.cutDraft(side, i, use.from ?? 0, to / 100)}
          />
          <button
            class="tool flat"
            aria-label={t.pattern.leaveOut(`${use.piece} · ${use.edge}`)}
            onClick={() => pattern.sewEdge(use.piece, use.edge)}
          >
            <Icon name="cross" />
          </button>
        </li>
      ))}
    </ul>
  );
}
