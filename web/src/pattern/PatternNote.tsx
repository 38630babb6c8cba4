// One line under the pattern: what was refused, what the hand or the pointer is at, or what to do next.

import type { Pieces } from '../api/types';
import type { ApiError } from '../api/http';
import { useAppState } from '../state/context';
import { seamTitle, seamWords } from '../state/seamNames';
import { lengthsText, seamLengths } from '../state/seamView';
import type { Held, PatternTool } from '../tools/PatternTool';
import { kDraftSeam, type ShownSeam } from './SeamShapes';
import { t } from '../texts/language';
import { patternFigure, patternSign } from '../texts/units';
import { Told } from '../texts/Message';

export interface PatternNoteProps {
  /** As they are shown. */
  pieces: Pieces;
  tool: PatternTool;
  held: Held | null;
  lit: ShownSeam | null;
}

export function PatternNote({ pieces, tool, held, lit }: PatternNoteProps) {
  const state = useAppState();
  const problem = state.editing.problem.value;
  if (problem) return <Refusal problem={problem} />;
  // As in the list of seams; what is held is longer or shorter than the service knows.
  const known = held ? undefined : pieces.seams.find((seam) => seam.id === lit?.seam.id);
  const said = placeOf(held) ?? lengthsOf(pieces, lit, known ? [known.length_a_mm, known.length_b_mm] : drawnLengths(pieces, lit), state.editing.range.value === null) ?? tool.say?.(state) ?? null;
  if (said === null) return null;
  return (
    <p class="pattern-note" role="status">
      {said}
    </p>
  );
}

function Refusal({ problem }: { problem: ApiError }) {
  return (
    <div class="pattern-note bad" role="alert">
      <p>
        <Told code={problem.code} detail={problem.detail} />
      </p>
      <p class="code">{[problem.code, problem.where].filter(Boolean).join(' · ')}</p>
    </div>
  );
}

/** Where the part is that is held. */
function placeOf(held: Held | null) {
  if (!held?.at) return null;
  const [x, y] = held.at;
  return (
    <>
      <b>{patternFigure(x)}</b>, <b>{patternFigure(y)}</b> {patternSign()}
    </>
  );
}

function drawnLengths({ pieces }: Pieces, lit: ShownSeam | null): [number, number] {
  if (!lit) return [0, 0];
  const { a, b } = seamLengths(pieces, lit.seam);
  return [a, b];
}

/** One that is proposed has no number yet. */
const titleOf = (pieces: Pieces, { seam }: ShownSeam): string =>
  pieces.seams.some(({ id }) => id === seam.id) ? seamTitle(pieces, seam.id) : seamWords(seam, pieces);

/** How long both sides of the lit seam are; of one that is being made how it is sewn, once both are there. */
function lengthsOf(pieces: Pieces, lit: ShownSeam | null, both_mm: readonly [number, number], both: boolean) {
  if (!lit || lit.seam.b.length === 0) return null;
  const { lengths, difference } = lengthsText(...both_mm);
  const drafted = lit.seam.id === kDraftSeam;
  return (
    <>
      <b>{drafted ? t.pattern.newSeam : titleOf(pieces, lit)}</b> <span class="figures">{lengths}</span> · {difference}
      {drafted && both && (
        <>
          {' · '}
          <kbd>{t.keys.names.Enter}</kbd> {t.keys.sewNow}
        </>
      )}
    </>
  );
}
