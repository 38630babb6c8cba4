// What a drape came to where it is not simply done: what is wrong, lit in both views, and the ways on as buttons.

import type { Pieces, Report } from '../api/types';
import { useCommands } from '../commands/context';
import { loading, valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { fixTitle, outcomesOf, unevenSeams, type Known, type Outcome } from '../state/outcome';
import { SeamChip } from './SeamChip';
import { sentence } from '../texts/told';

export function OutcomeList() {
  const state = useAppState();
  const job = state.job.value;
  if (!job) return null;
  const pattern = valueOf(state.pieces.value ?? loading);
  const known = knownOf(pattern);
  const report: Report | null = valueOf(state.report.value ?? loading);
  return (
    <>
      {outcomesOf(job, report, known, state.since.value).map((outcome) => (
        <Said key={outcome.title} outcome={outcome} all={known.seams} />
      ))}
    </>
  );
}

/** What the words about a drape may name, as the pattern is now. */
function knownOf(pattern: Pieces | null): Known {
  const { pieces = [], seams = [], max_time_s } = pattern ?? {};
  return {
    pieces: pieces.map(({ id }) => id),
    seams: seams.map(({ id }) => id),
    sewn: seams,
    uneven: unevenSeams(seams),
    ...(max_time_s !== undefined && { max_time_s }),
  };
}

/** `all`: the pattern's seams, in order. */
function Said({ outcome, all }: { outcome: Outcome; all: readonly string[] }) {
  const { submitting, editing, dressing } = useAppState();
  const commands = useCommands();
  const { tone, title, text, detail, seams, pieces, fixes, code } = outcome;
  const busy = submitting.value || editing.busy.value || dressing.busy.value !== '';
  return (
    <div class={`reason reason-${tone}`} role={tone === 'bad' ? 'alert' : undefined}>
      <h3>{title}</h3>
      {text && <p>{text}</p>}
      {detail && (
        <small class="told" lang="en">
          {sentence(detail)}
        </small>
      )}
      {seams.length + pieces.length > 0 && (
        <p class="sewn-in">
          {seams.map((seam) => (
            <SeamChip key={seam} seam={seam} />
          ))}
          {pieces.map((piece) => (
            <PieceChip key={piece} piece={piece} />
          ))}
        </p>
      )}
      {fixes.length > 0 && (
        <div class="button-row">
          {fixes.map((fix, i) => (
            <button
              key={fix.kind}
              class={i === 0 ? 'primary' : 'plain'}
              disabled={busy}
              onClick={() => void commands.mend(fix)}
            >
              {fixTitle(fix, all)}
            </button>
          ))}
        </div>
      )}
      {tone === 'bad' && code && <p class="code">{code}</p>}
    </div>
  );
}

/** A piece by its name; a click lights it in both views. */
function PieceChip({ piece }: { piece: string }) {
  const { selected } = useAppState();
  const commands = useCommands();
  const on = selected.value === piece;
  return (
    <button class="seam-chip" aria-pressed={on} onClick={() => commands.select(on ? null : piece)}>
      {piece}
    </button>
  );
}
