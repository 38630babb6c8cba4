// The seam that is being made: both sides as they are clicked together.

import type { Pieces } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { lengthsText, seamColour, seamLengths, seriesText, type Side } from '../state/seamView';
import { Icon } from '../controls/Icon';
import { NumberField } from '../controls/NumberField';

export function SeamDraftPanel({ pieces }: { pieces: Pieces }) {
  const state = useAppState();
  const { pattern } = useCommands();
  const { draft } = state.editing;
  const { a, b, side, sameDirection } = draft.value;
  const { a: lengthA, b: lengthB } = seamLengths(pieces.pieces, { id: '', a, b });
  const both = a.length > 0 && b.length > 0;
  const { lengths, difference } = lengthsText(lengthA, lengthB);
  return (
    <section class="seam-draft" aria-label="New seam" style={{ '--seam': seamColour(pieces.seams.length) }}>
      <h3>New seam</h3>
      {(['a', 'b'] as const).map((one) => (
        <button
          key={one}
          class="draft-side"
          aria-pressed={side === one}
          onClick={() => (draft.value = { ...draft.value, side: one })}
        >
          <em>{one.toUpperCase()}</em>
          <span>{draft.value[one].length > 0 ? seriesText(draft.value[one], pieces.pieces) : 'Click edges on the pieces'}</span>
          <small>{draft.value[one].length > 0 ? `${(one === 'a' ? lengthA : lengthB).toFixed(1)} mm` : ''}</small>
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
          Sew
        </button>
        <button class="plain" disabled={!both} aria-pressed={sameDirection} onClick={() => pattern.turnDraft()}>
          Reverse
        </button>
        <button class="plain" onClick={() => pattern.clearDraft()}>
          Clear
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
    <ul class="draft-edges" aria-label={`Edges of side ${side.toUpperCase()}`}>
      {series.map((use, i) => (
        <li key={`${use.piece} ${use.edge}`}>
          <span>
            {use.piece} · {use.edge}
          </span>
          <NumberField
            label="from"
            unit="%"
            value={100 * (use.from ?? 0)}
            take={(from) => pattern.cutDraft(side, i, from / 100, use.to ?? 1)}
          />
          <NumberField
            label="to"
            unit="%"
            value={100 * (use.to ?? 1)}
            take={(to) => pattern.cutDraft(side, i, use.from ?? 0, to / 100)}
          />
          <button
            class="tool flat"
            aria-label={`Leave out ${use.piece} · ${use.edge}`}
            onClick={() => pattern.sewEdge(use.piece, use.edge)}
          >
            <Icon name="cross" />
          </button>
        </li>
      ))}
    </ul>
  );
}
