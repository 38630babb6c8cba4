// Where the pieces stand before the drape, and what the look at them found.

import { useEffect, useRef } from 'preact/hooks';
import type { BodyPart, BoxSide, PieceWish } from '../api/dressing';
import type { Piece } from '../api/types';
import { useCommands } from '../commands/context';
import { kAway_mm } from '../commands/DressingCommands';
import { loading, valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { kParts, partTitle } from '../state/dressing';
import { cssColour } from '../state/patternGeometry';
import { Refusal } from './BodyPanel';
import { NumberField } from '../controls/NumberField';
import { ProblemList } from './ProblemList';
import { t } from '../texts/language';
import { capital } from '../state/words';

export function ArrangePanel() {
  const state = useAppState();
  const commands = useCommands();
  const { dressing } = state;
  if (!state.projectId.value) return <p class="hint">{t.arrange.openProject}</p>;
  const marks = dressing.marks.value;
  const busy = dressing.busy.value !== '';
  return (
    <>
      <div class="arrange-head">
        <button class="primary" disabled={busy} onClick={() => void commands.dressing.arrange()}>
          {t.arrange.arrange}
        </button>
        <button
          class="plain"
          aria-pressed={marks.boxes}
          onClick={() => commands.dressing.showMarks({ boxes: !marks.boxes })}
        >
          {t.arrange.boxes}
        </button>
      </div>
      <Refusal problem={dressing.placeProblem.value} />
      <ProblemList />
      <PieceList />
    </>
  );
}

function PieceList() {
  const state = useAppState();
  const pieces = valueOf(state.pieces.value ?? loading)?.pieces ?? [];
  if (pieces.length === 0) return null;
  return (
    <section class="piece-places" aria-label={t.arrange.places}>
      <h3>{t.common.pieces}</h3>
      <p class="hint">{t.arrange.dragPiece}</p>
      <label class="check">
        <input
          type="checkbox"
          checked={state.dressing.partners.value}
          onChange={(event) => (state.dressing.partners.value = event.currentTarget.checked)}
        />
        {t.arrange.partner}
      </label>
      <ul>
        {pieces.map((piece) => (
          <PieceRow key={piece.id} piece={piece} />
        ))}
      </ul>
    </section>
  );
}

function PieceRow({ piece }: { piece: Piece }) {
  const state = useAppState();
  const commands = useCommands();
  const chosen = state.selected.value === piece.id;
  const row = useRef<HTMLLIElement>(null);
  useEffect(() => {
    // A finding that was clicked stays in sight, whichever piece it has selected.
    if (chosen && !state.dressing.finding.peek()) row.current?.scrollIntoView({ block: 'nearest' });
  }, [chosen, state]);
  // Before it is known where the piece stands there is nothing to go on from.
  const known = state.dressing.check.value !== null || state.dressing.startProblem.value !== null;
  const hand = state.dressing.check.value?.pieces.find((one) => one.id === piece.id)?.by_hand;
  const made = state.dressing.arrangement.value?.pieces.find((one) => one.id === piece.id)?.place;
  const where = hand ? t.arrange.byHand(`${t.names.parts[hand.part]}, ${t.names.sides[hand.side]}`) : made;
  return (
    <li ref={row} class={chosen ? 'chosen' : ''}>
      <button
        class="piece-row"
        aria-expanded={chosen}
        onClick={() => commands.select(chosen ? null : piece.id)}
        onPointerEnter={() => commands.hover(piece.id)}
        onPointerLeave={() => commands.hover(null)}
      >
        <i style={{ background: cssColour(piece.colour) }} aria-hidden="true" />
        <b>{piece.id}</b>
        <small>{where ?? ''}</small>
      </button>
      {chosen && known && <PlaceForm key={piece.id} piece={piece.id} />}
    </li>
  );
}

const kSides: BoxSide[] = ['front', 'back', 'left', 'right'];

/** Offered where no body stands that could say where a piece is. */
const kFirstPlace: Omit<PieceWish, 'piece'> = {
  part: 'torso',
  side: 'front',
  at_mm: [0, 0],
  away_mm: kAway_mm,
  turn: 0,
  wrapped: false,
  flipped: false,
};

/** Where the piece stands, by hand or as it was arranged: every change of it is sent. */
function PlaceForm({ piece }: { piece: string }) {
  const commands = useCommands();
  const state = useAppState();
  const { dressing } = state;
  const wish = dressing.check.value?.pieces.find((one) => one.id === piece)?.stands ?? kFirstPlace;
  const busy = dressing.busy.value !== '';
  const put = (more: Partial<PieceWish>): void => void commands.dressing.place({ ...wish, piece, ...more });
  const { part, side, at_mm, away_mm, turn } = wish;
  return (
    <div class="place-form">
      <label>
        <span>{t.arrange.part}</span>
        <select value={part} disabled={busy} onChange={(event) => put({ part: event.currentTarget.value as BodyPart })}>
          {kParts.map((one) => (
            <option key={one} value={one}>
              {partTitle(one)}
            </option>
          ))}
        </select>
      </label>
      <span class="choice" role="radiogroup" aria-label={t.arrange.side}>
        {kSides.map((one) => (
          <button
            key={one}
            role="radio"
            aria-checked={side === one}
            disabled={busy}
            onClick={() => put({ side: one })}
          >
            {capital(t.names.sides[one])}
          </button>
        ))}
      </span>
      <div class="place-numbers">
        <NumberField label={t.arrange.across} value={at_mm[0]} length digits={0} take={(x) => put({ at_mm: [x, at_mm[1]] })} />
        <NumberField label={t.arrange.up} value={at_mm[1]} length digits={0} take={(y) => put({ at_mm: [at_mm[0], y] })} />
        <NumberField label={t.arrange.away} value={away_mm} length digits={0} take={(away) => put({ away_mm: away })} />
        <NumberField label={t.arrange.turn} value={turn} unit="°" digits={0} take={(angle) => put({ turn: angle })} />
      </div>
      <Turns wish={wish} busy={busy} put={put} />
    </div>
  );
}

interface TurnsProps {
  wish: Pick<PieceWish, 'wrapped' | 'flipped'>;
  busy: boolean;
  put(more: Partial<PieceWish>): void;
}

/** Whether the piece is rolled, and which of its sides is the outer one. */
function Turns({ wish: { wrapped, flipped }, busy, put }: TurnsProps) {
  return (
    <>
      <label class="check">
        <input
          type="checkbox"
          checked={wrapped}
          disabled={busy}
          onChange={(event) => put({ wrapped: event.currentTarget.checked })}
        />
        {t.arrange.rolled}
      </label>
      <div class="button-row">
        <button
          class="plain"
          aria-pressed={flipped}
          disabled={busy}
          title={t.arrange.overTip}
          onClick={() => put({ flipped: !flipped })}
        >
          {t.arrange.turnOver}
        </button>
      </div>
    </>
  );
}
