// Seams that the pieces ask for: looked for on request, accepted by ticks.

import type { ApiError } from '../api/http';
import type { Piece, Pieces, SeamProposal } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { seriesText } from '../state/seamNames';
import { lengthsText } from '../state/seamView';
import { percent } from '../state/words';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

export function ProposalList({ pieces }: { pieces: Pieces }) {
  const { proposals } = useAppState().editing;
  const found = proposals.value;
  if (pieces.pieces.length === 0) return null;
  return (
    <section class="proposals" aria-label={t.pattern.proposed}>
      <h3>{t.pattern.proposals}</h3>
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
  const { chosen, busy } = useAppState().editing;
  const { seams } = useCommands();
  if (proposals.length === 0) return <p class="hint">{t.pattern.noneFurther}</p>;
  return (
    <>
      <ul>
        {proposals.map((one) => (
          <ProposalRow
            key={one.id}
            proposal={one}
            pieces={pieces}
            on={chosen.value.has(one.id)}
            turn={(on) => seams.choose(one.id, on)}
          />
        ))}
      </ul>
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

export interface ProposalRowProps {
  proposal: SeamProposal;
  /** Whose edges it names. */
  pieces: readonly Piece[];
  on: boolean;
  turn(on: boolean): void;
  light?(on: boolean): void;
  colour?: string;
}

export function ProposalRow({ proposal, pieces, on, turn, light, colour }: ProposalRowProps) {
  const { lengths, difference } = lengthsText(proposal.length_a_mm, proposal.length_b_mm);
  return (
    <li class="proposal" onPointerEnter={() => light?.(true)} onPointerLeave={() => light?.(false)}>
      <label>
        <input
          type="checkbox"
          checked={on}
          onFocus={() => light?.(true)}
          onBlur={() => light?.(false)}
          onChange={(event) => turn(event.currentTarget.checked)}
        />
        {colour && <i style={{ background: colour }} aria-hidden="true" />}
        <span class="proposal-text">
          <b>
            {seriesText(proposal.a, pieces)} <span aria-hidden="true">⇄</span> {seriesText(proposal.b, pieces)}
          </b>
          <small>
            {lengths} · {difference}
          </small>
        </span>
        <em title={t.pattern.confidence}>{percent(proposal.confidence, 0)}</em>
      </label>
    </li>
  );
}
