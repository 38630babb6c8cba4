// A whole piece on its way over the plane.

import type { Point } from '../api/types';
import type { Drag, Hand, Held } from './PatternTool';

const alongAxis = ([x, y]: Point): Point => (Math.abs(x) > Math.abs(y) ? [x, 0] : [0, y]);

export function pieceDrag({ commands }: Hand, piece: string): Drag {
  return {
    to: (by, { shift }): Held => ({
      piece,
      part: null,
      by: shift ? alongAxis(by) : by,
      at: null,
      guides: [],
      shown: (shape) => shape,
    }),
    drop: ({ by }) => commands.pattern.movePiece(piece, by),
  };
}
