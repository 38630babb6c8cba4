// A piece on the plane with its seams, and what the tool can take hold of on it.

import type { Point, SeamSides } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { minus } from '../state/outline';
import type { PlacedPiece } from '../state/layout';
import { seamsOfEdge } from '../state/seamView';
import type { PatternTool } from '../tools/PatternTool';
import { EditMarks } from './EditMarks';
import { PieceMap } from './PieceMap';
import { PieceShape } from './PieceShape';
import { SeamShapes, type ShownSeam } from './SeamShapes';
import type { Hands } from './useHands';

export interface PlacedPieceViewProps {
  placed: PlacedPiece;
  /** Those of the project. */
  known: readonly SeamSides[];
  /** Those with the one that is being made. */
  seams: ShownSeam[];
  lit: string | null;
  scale: number;
  tool: PatternTool;
  hands: Hands;
  worldOf(event: MouseEvent): Point;
}

export function PlacedPieceView(props: PlacedPieceViewProps) {
  const { placed, seams, lit, scale, tool, hands, worldOf } = props;
  const state = useAppState();
  const commands = useCommands();
  const { piece } = placed;
  const { clickSeam } = tool;
  return (
    <g onPointerDown={(event) => hands.pressPiece(piece.id, event)}>
      <PieceShape
        placed={placed}
        scale={scale}
        selected={state.selected.value === piece.id}
        hovered={state.hovered.value === piece.id}
        look={state.looks.value.get(piece.id) ?? null}
        cover={state.clothMap.value && !state.beforeDrape.value ? <PieceMap placed={placed} worldOf={worldOf} /> : null}
        onSelect={() => hands.clickPiece(piece.id)}
        onHover={(on) => commands.hover(on ? piece.id : null)}
      >
        <SeamShapes
          shown={seams}
          piece={piece.id}
          scale={scale}
          lit={lit}
          onLight={(seam) => commands.pattern.lightSeam(seam)}
          onSelect={clickSeam ? (seam) => clickSeam({ state, commands }, seam) : null}
        />
        <Touchable {...props} />
      </PieceShape>
    </g>
  );
}

/** Edges, points and handles. */
function Touchable({ placed, known, scale, tool, hands, worldOf }: PlacedPieceViewProps) {
  const state = useAppState();
  const commands = useCommands();
  const { piece, offset } = placed;
  const { part, draft } = state.editing;
  const lightEdge = (edge: string | null): void => {
    const [first] = edge === null ? [] : seamsOfEdge(known, piece.id, edge);
    commands.pattern.lightSeam(first === undefined ? null : known[first]!.id);
  };
  const double = (edge: string, event: MouseEvent): void =>
    tool.edges?.double?.({ state, commands }, { piece: piece.id, edge }, minus(worldOf(event), offset));
  return (
    <EditMarks
      piece={piece}
      scale={scale}
      tool={tool}
      selected={state.selected.value === piece.id}
      part={part.value}
      draft={draft.value}
      draftColour={known.length}
      onEdge={(edge, event) => hands.pressEdge({ piece: piece.id, edge }, event)}
      onLight={lightEdge}
      onInsert={double}
      onGrab={hands.grab}
      onNudge={hands.nudge}
    />
  );
}
