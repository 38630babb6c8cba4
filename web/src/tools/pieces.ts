// Moves whole pieces, and selects them and seams.

import { kRestingTool } from '../state/editing';
import { pieceDrag } from './pieceDrag';
import type { PatternTool } from './PatternTool';
import { t } from '../texts/language';

export const pieces: PatternTool = {
  id: kRestingTool,
  keepsPart: false,
  words: () => t.keys.tools.pieces,
  key: 'A',
  cursor: { selected: 'move' },
  clickPiece: ({ state, commands }, piece) => {
    commands.pattern.selectPart(null);
    commands.select(state.selected.value === piece ? null : piece);
  },
  dragPiece: pieceDrag,
  clickSeam: ({ commands }, seam) => commands.pattern.selectSeam(seam),
};
