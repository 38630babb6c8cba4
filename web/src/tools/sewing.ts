// What is the same for all tools that make a seam, whatever of an edge they take.

import { SeamDraftPanel } from './SeamDraftPanel';
import type { EdgePlace, Hand, PatternTool } from './PatternTool';

/** Takes an edge into the seam that is being made, or gives it back; Enter on one that is taken goes on, as after clicks. */
export function sewByKeys({ state, commands }: Hand, { piece, edge }: EdgePlace, key: string | null): void {
  const draft = state.editing.draft.value;
  const taken = draft[draft.side].some((use) => use.piece === piece && use.edge === edge);
  if (taken && key === 'Enter') void commands.seams.finishSide();
  else commands.seams.sewEdge(piece, edge);
}

/** Without what tells such tools apart: their names, and what they make of the pointer on edges. */
export const sewing: Pick<PatternTool, 'keepsPart' | 'cursor' | 'clickPiece' | 'Panel'> = {
  keepsPart: false,
  cursor: { paper: 'crosshair', piece: 'crosshair' },
  clickPiece: ({ commands }, piece) => {
    commands.pattern.selectPart(null);
    commands.select(piece);
  },
  Panel: SeamDraftPanel,
};
