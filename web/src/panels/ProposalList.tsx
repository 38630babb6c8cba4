// Seams that the pieces ask for: looked for on request, accepted by ticks.

import type { VNode } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import type { ApiError } from '../api/http';
import type { Piece, Pieces, SeamProposal } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { seriesText } from '../state/seamNames';
import { holds, lengthsText, unsewn } from '../state/seamView';
import { percent } from '../state/words';
import { UnsewnPieces } from './UnsewnPieces';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

export function ProposalList({ pieces }: { pieces: Pieces }) {
  const { editing, selected } = useAppState();
  const commands = useCommands();
  const found = editing.proposals.value;
  const section = useRef<HTMLElement>(null);
  const stays = useRef(false);
  // What was asked for is seen, also when a piece that was chosen here makes what stands above longer.
  const reached = found?.state;
  useEffect(() => {
    if (reached) section.current?.scrollIntoView({ block: 'nearest' });
  }, [reached]);
  useEffect(() => {
    if (stays.current) section.current?.scrollIntoView({ block: 'nearest' });
    stays.current = false;
  }, [selected.value]);
  const choose = (piece: string | null): void => {
    stays.current = true;
    commands.select(piece);
  };
  if (pieces.pieces.length === 0) return null;
  return (
    <section ref={section} class="proposals" aria-label={t.pattern.proposed}>
      <h3>{t.pattern.proposals}</h3>
      <UnsewnPieces
        pieces={unsewn(pieces.pieces, pieces.seams)}
        chosen={selected.value}
        choose={choose}
        light={(piece) => commands.hover(piece)}
      />
      {(found === null || found.state === 'failed') && <Ask failure={found} />}
      {found?.state === 'loading' && (
        <p class="busy" role="status">
          <span class="spinner" aria-hidden="true" /> {t.pattern.looking}
        </p>
      )}
      {found?.state === 'ready' && <Found proposals={found.value} pieces={pieces.pieces} />}
    </section>
  );
}

/** Before anybody asked, and after it came to nothing. */
function Ask({ failure }: { failure: { error: ApiError } | null }) {
  const { busy } = useAppState().editing;
  const { seams } = useCommands();
  return (
    <>
      {failure && <p class="hint bad"><Told code={failure.error.code} detail={failure.error.detail} /></p>}
      <button class="plain" disabled={busy.value} onClick={() => void seams.propose()}>
        {t.pattern.lookForSeams}
      </button>
    </>
  );
}

function Found({ proposals, pieces }: { proposals: readonly SeamProposal[]; pieces: readonly Piece[] }) {
  const { editing, selected } = useAppState();
  const { chosen, busy } = editing;
  const commands = useCommands();
  const { seams } = commands;
  // A row that goes away under the pointer is never left by it.
  useEffect(() => () => seams.lightProposal(null), [seams]);
  if (proposals.length === 0) return <p class="hint">{t.pattern.noneFurther}</p>;
  return (
    <>
      <ProposalRows
        proposals={proposals}
        of={selected.value}
        all={() => commands.select(null)}
        row={(one) => (
          <ProposalRow
            key={one.id}
            proposal={one}
            pieces={pieces}
            on={chosen.value.has(one.id)}
            turn={(on) => seams.choose(one.id, on)}
            light={(on) => seams.lightProposal(on ? one : null)}
            accept={busy.value ? undefined : () => void seams.acceptProposal(one.id)}
          />
        )}
      />
      <button
        class="primary"
        disabled={chosen.value.size === 0 || busy.value}
        onClick={() => void seams.acceptProposals()}
      >
        {t.pattern.sewSeams(chosen.value.size)}
      </button>
    </>
  );
}

interface ProposalRowsProps {
  proposals: readonly SeamProposal[];
  /** A piece whose proposals are to stand alone. */
  of: string | null;
  /** All are to stand there again. */
  all(): void;
  row(proposal: SeamProposal): VNode;
}

/** Those with which a garment is begun; then those that want a look, each by itself. */
export function ProposalRows({ proposals, of, all, row }: ProposalRowsProps) {
  const shown = proposals.filter((one) => of === null || holds(one, of));
  const sure = shown.filter((one) => one.to_wear);
  const unsure = shown.filter((one) => !one.to_wear);
  return (
    <>
      {of !== null && (
        <p class="hint">
          {shown.length > 0 ? t.pattern.proposedFor(of) : t.pattern.nothingFor(of)}{' '}
          <button class="link" onClick={all}>
            {t.pattern.allProposals(proposals.length)}
          </button>
        </p>
      )}
      {sure.length > 0 && <ul>{sure.map(row)}</ul>}
      {unsure.length > 0 && <p class="hint">{t.pattern.unsure}</p>}
      {unsure.length > 0 && <ul aria-label={t.pattern.unsureOnes}>{unsure.map(row)}</ul>}
    </>
  );
}

export interface ProposalRowProps {
  proposal: SeamProposal;
  /** Whose edges it names. */
  pieces: readonly Piece[];
  on: boolean;
  turn(on: boolean): void;
  light(on: boolean): void;
  /** Sews this one alone. */
  accept?: (() => void) | undefined;
  colour?: string;
}

export function ProposalRow({ proposal, pieces, on, turn, light, accept, colour }: ProposalRowProps) {
  const { lengths, difference } = lengthsText(proposal.length_a_mm, proposal.length_b_mm);
  const [a, b] = [seriesText(proposal.a, pieces), seriesText(proposal.b, pieces)];
  const words = `${a} ⇄ ${b}`;
  return (
    <li class="proposal" onPointerEnter={() => light(true)} onPointerLeave={() => light(false)}>
      <label>
        <input
          type="checkbox"
          checked={on}
          onFocus={() => light(true)}
          onBlur={() => light(false)}
          onChange={(event) => turn(event.currentTarget.checked)}
        />
        {colour && <i style={{ background: colour }} aria-hidden="true" />}
        <span class="proposal-text">
          <b>
            {a} <span aria-hidden="true">⇄</span> {b}
          </b>
          <small>
            {lengths} · {difference}
          </small>
        </span>
        <em title={t.pattern.confidence}>{percent(proposal.confidence, 0)}</em>
      </label>
      {accept && (
        <button class="plain small" aria-label={t.pattern.sewThis(words)} onFocus={() => light(true)} onBlur={() => light(false)} onClick={accept}>
          {t.pattern.sewOne}
        </button>
      )}
    </li>
  );
}
