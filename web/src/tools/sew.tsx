// Sews edges together: those of one side are clicked, then those of the other.

import type { AppState } from '../state/AppState';
import { SeamDraftPanel } from './SeamDraftPanel';
import type { EdgePlace, Hand, PatternTool } from './PatternTool';
import { t } from '../texts/language';

/** Takes an edge into the seam that is being made, or gives it back; Enter on one that is taken goes on, as after clicks. */
export function sewByKeys({ state, commands }: Hand, { piece, edge }: EdgePlace, key: string | null): void {
  const draft = state.editing.draft.value;
  const taken = draft[draft.side].some((use) => use.piece === piece && use.edge === edge);
  if (taken && key === 'Enter') void commands.pattern.finishSide();
  else commands.pattern.sewEdge(piece, edge);
}

export const sew: PatternTool = {
  id: 'sew',
  keepsPart: false,
  words: () => t.keys.tools.sew,
  key: 'N',
  cursor: { paper: 'crosshair', piece: 'crosshair' },
  clickPiece: ({ commands }, piece) => {
    commands.pattern.selectPart(null);
    commands.select(piece);
  },
  edges: {
    tabbed: 'all',
    press: sewByKeys,
  },
  say: ({ editing }: AppState) => {
    const { side, a } = editing.draft.value;
    return (
      <>
        {side === 'a' || a.length === 0 ? t.keys.sewOne : t.keys.sewOther} <kbd>{t.keys.names.Enter}</kbd>
      </>
    );
  },
  Panel: SeamDraftPanel,
};
