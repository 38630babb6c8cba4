// Moves whole pieces, and selects them and seams.

import { kRestingTool } from '../state/editing';
import { pieceDrag } from './pieceDrag';
import type { PatternTool } from './PatternTool';

export const pieces: PatternTool = {
  id: kRestingTool,
  keepsPart: false,
  title: 'Pieces',
  key: 'A',
  hint: 'Select and move pieces',
  help: 'Move whole pieces',
  cursor: { selected: 'move' },
  clickPiece: ({ state, commands }, piece) => {
    commands.pattern.selectPart(null);
    commands.select(state.selected.value === piece ? null : piece);
  },
  dragPiece: pieceDrag,
  clickSeam: ({ commands }, seam) => commands.pattern.selectSeam(seam),
};
