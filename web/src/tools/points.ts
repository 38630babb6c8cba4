// Changes outlines: points, corners and handles are dragged, a double click on an edge makes a point.

import type { Edit, Piece, Point } from '../api/types';
import { loading, valueOf, type AppState } from '../state/AppState';
import type { Part } from '../state/editing';
import {
  add,
  aligned,
  distance,
  jointsOf,
  nearestOn,
  snapped45,
  withHandleMoved,
  withPointMoved,
} from '../state/outline';
import { pieceDrag } from './pieceDrag';
import type { Drag, Hand, Held, PatternTool, Way } from './PatternTool';
import { t } from '../texts/language';

export const points: PatternTool = {
  id: 'points',
  keepsPart: true,
  words: () => t.keys.tools.points,
  key: 'Z',
  clickPiece: ({ commands }, piece) => {
    commands.pattern.selectPart(null);
    commands.select(piece);
  },
  dragPiece: pieceDrag,
  edges: {
    tabbed: 'selected',
    press: ({ commands }, at) => commands.pattern.selectPart({ kind: 'edge', ...at }),
    double: ({ state, commands }, { piece, edge }, place) => {
      const found = pieceOf(state, piece)?.edges.find((one) => one.id === edge);
      if (found) void commands.edits.send({ edit: 'insert_point', piece, edge, at: nearestOn(found, place).at });
    },
  },
  grab: (hand, part, at) => {
    hand.commands.pattern.selectPart(part);
    return partDrag(hand, part, at);
  },
  say: (state) => (state.selected.value === null ? t.keys.clickPiece : null),
};

/** As the service has it: what is held is shown elsewhere already. */
const pieceOf = (state: AppState, id: string): Piece | undefined =>
  valueOf(state.pieces.value ?? loading)?.pieces.find((piece) => piece.id === id);

function partDrag({ state, commands }: Hand, part: Part, was: Point): Drag {
  const { piece } = part;
  const to = (by: Point, way: Way): Held => {
    const { at, guides } = snapped(state, piece, was, add(was, by), way);
    return { piece, part, by: [0, 0], at, guides, shown: (shape) => withPartAt(shape, part, at) };
  };
  return { to, drop: ({ at }) => (at ? commands.edits.send(moveEdit(part, at)) : Promise.resolve()) };
}

/** Where the part comes to lie when the pointer is at `free`, and the points that it took its height or column from. */
function snapped(state: AppState, piece: string, was: Point, free: Point, way: Way): { at: Point; guides: Point[] } {
  if (way.shift) return { at: snapped45(was, free), guides: [] };
  if (way.alt) return { at: free, guides: [] };
  const joints = (pieceOf(state, piece)?.edges ?? []).flatMap(jointsOf);
  return aligned(
    free,
    joints.filter((point) => distance(point, was) > 0.01),
    way.reach,
  );
}

function withPartAt(piece: Piece, part: Part, at: Point): Piece {
  if (part.kind === 'point') return withPointMoved(piece, part.edge, part.point, at);
  return part.kind === 'handle' ? withHandleMoved(piece, part.edge, part.curve, part.handle, at) : piece;
}

/** Hundredths of a millimetre are as fine as a hand is. */
const rounded = ([x, y]: Point): Point => [Math.round(x * 100) / 100, Math.round(y * 100) / 100];

/** The edit that a drag of a point or a handle comes to. */
function moveEdit(part: Part, at: Point): Edit {
  const { piece, edge } = part;
  const to = rounded(at);
  if (part.kind === 'handle') return { edit: 'move_handle', piece, edge, curve: part.curve, handle: part.handle, to };
  return { edit: 'move_point', piece, edge, point: part.kind === 'point' ? part.point : 0, to };
}
