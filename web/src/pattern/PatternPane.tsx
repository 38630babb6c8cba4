// The flat pieces beside the 3D view: pan, zoom, fit; names, sizes, grain; seams in pairs of one colour; selecting, editing
// and sewing by hand.

import { useComputed, useSignalEffect } from '@preact/signals';
import type { Pieces, Point, SeamSides } from '../api/types';
import { useCommands } from '../commands/context';
import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { minus, nearestOn } from '../state/outline';
import { layOut, type PlacedPiece } from '../state/patternGeometry';
import { lengthsText, seamLengths, seamParts, seamsOfEdge, type SeamDraft } from '../state/seamView';
import { sentence } from '../state/words';
import { EditMarks } from './EditMarks';
import { PatternTools } from './PatternTools';
import { PieceShape } from './PieceShape';
import { SeamShapes, Threads, type ShownSeam } from './SeamShapes';
import { useHands, type Hands, type Held } from './useHands';
import { usePlaneView } from './usePlaneView';

export function PatternPane() {
  const state = useAppState();
  const pieces = state.pieces.value;
  return (
    <section class={`pattern tool-${state.editing.tool.value}`} aria-label="Pattern">
      {pieces === null && <p class="hint">The flat pieces of the garment appear here.</p>}
      {pieces?.state === 'loading' && (
        <div class="skeleton-pieces" role="status" aria-label="Loading the pattern">
          <i />
          <i />
          <i />
          <i />
        </div>
      )}
      {pieces?.state === 'failed' && (
        <div class="pane-error" role="alert">
          <h3>The pattern cannot be shown</h3>
          <p>{sentence(pieces.error.detail)}</p>
          <p class="code">
            {pieces.error.code}
            {pieces.error.where && <> · {pieces.error.where}</>}
          </p>
        </div>
      )}
      {pieces?.state === 'ready' && <Plane pieces={pieces.value} />}
    </section>
  );
}

/** A piece that is dragged, where the pointer has it. */
const movedAlong = (placed: PlacedPiece, held: Held | null): PlacedPiece => {
  if (held?.kind !== 'piece' || held.piece !== placed.piece.id) return placed;
  const offset: Point = [placed.offset[0] + held.by[0], placed.offset[1] + held.by[1]];
  const centre: Point = [placed.centre[0] + held.by[0], placed.centre[1] + held.by[1]];
  return { ...placed, offset, centre };
};

function Plane({ pieces }: { pieces: Pieces }) {
  const state = useAppState();
  const commands = useCommands();
  const { editing } = state;
  const placed = useComputed(() =>
    layOut(valueOf(state.pieces.value ?? { state: 'loading' })?.pieces ?? [], editing.offsets.value),
  );
  useSignalEffect(() => {
    const next = new Map(placed.value.map((one) => [one.piece.id, one.offset]));
    const known = editing.offsets.peek();
    if ([...next.keys()].some((id) => !known.has(id))) editing.offsets.value = new Map([...known, ...next]);
  });
  const plane = usePlaneView(
    () => placed.value.map((piece) => piece.box),
    () => state.projectId.value,
  );
  const clickPiece = (piece: string): void => {
    commands.pattern.selectPart(null);
    commands.select(state.selected.value === piece && editing.tool.value === 'pieces' ? null : piece);
  };
  const hands = useHands({
    state,
    commands: commands.pattern,
    view: () => plane.view.value,
    move: plane.move,
    clickPaper: () => {
      commands.pattern.selectPart(null);
      commands.select(null);
    },
    clickPiece,
    placed: () => placed.value,
  });

  const { scale } = plane.view.value;
  const shown = pieces.pieces.map(hands.shown);
  const seams = seamsShown({ ...pieces, pieces: shown }, editing.draft.value);
  const drafted = seams.find((one) => one.seam.id === kDraft);
  const lit = drafted ? kDraft : (editing.litSeam.value ?? editing.seam.value);
  const litSeam = seams.find((one) => one.seam.id === lit) ?? null;
  const where = placed.value.map((one) => movedAlong(one, hands.held));
  return (
    <>
      <svg
        ref={plane.svg}
        class="plane"
        tabindex={0}
        viewBox={plane.viewBox}
        onWheel={plane.wheel}
        onKeyDown={plane.keys}
        {...hands.plane}
        aria-label={`${pieces.pieces.length} pieces; arrow keys move, plus and minus zoom, F fits`}
        role="group"
      >
        <Paper scale={scale} />
        {where.map((one) => (
          <PlacedPieceView
            key={one.piece.id}
            placed={{ ...one, piece: shown.find((piece) => piece.id === one.piece.id) ?? one.piece }}
            pieces={pieces}
            seams={seams}
            lit={lit}
            scale={scale}
            hands={hands}
            worldOf={plane.worldOf}
            click={() => clickPiece(one.piece.id)}
          />
        ))}
        {litSeam && <Threads shown={litSeam} placed={where} scale={scale} />}
        <Guides held={hands.held} placed={where} />
      </svg>
      <PatternTools />
      <div class="plane-tools" role="toolbar" aria-label="Pattern view">
        <button class="tool" title="Zoom out (−)" aria-label="Zoom out" onClick={() => plane.zoom(0.8)}>
          −
        </button>
        <button class="tool wide" title="Fit all pieces (F)" onClick={plane.fitAll}>
          Fit
        </button>
        <button class="tool" title="Zoom in (+)" aria-label="Zoom in" onClick={() => plane.zoom(1.25)}>
          +
        </button>
      </div>
      <Note pieces={{ ...pieces, pieces: shown }} held={hands.held} lit={litSeam} />
    </>
  );
}

/** Id of the seam that is being made, among those that are shown. */
const kDraft = 'new';

function seamsShown({ pieces, seams }: Pieces, draft: SeamDraft): ShownSeam[] {
  const all: SeamSides[] = [...seams];
  if (draft.a.length > 0) all.push({ id: kDraft, a: draft.a, b: draft.b, same_direction: draft.sameDirection });
  return all.map((seam, index) => ({ seam, index, parts: seamParts(pieces, seam) }));
}

interface PlacedPieceViewProps {
  placed: PlacedPiece;
  pieces: Pieces;
  seams: ShownSeam[];
  lit: string | null;
  scale: number;
  hands: Hands;
  worldOf(event: MouseEvent): Point;
  click(): void;
}

/** A piece with its seams and what can be taken hold of on it. */
function PlacedPieceView({ placed, pieces, seams, lit, scale, hands, worldOf, click }: PlacedPieceViewProps) {
  const state = useAppState();
  const commands = useCommands();
  const { pattern } = commands;
  const { piece, offset } = placed;
  const tool = state.editing.tool.value;
  const draft = state.editing.draft.value;
  const selected = state.selected.value === piece.id;
  const pressEdge = (edge: string, event: PointerEvent | KeyboardEvent): void => {
    if (event.type === 'pointerdown' && (event as PointerEvent).button !== 0) return;
    event.stopPropagation();
    if (tool === 'points') pattern.selectPart({ kind: 'edge', piece: piece.id, edge });
    if (tool !== 'sew') return;
    // Enter on an edge that is taken already goes on, as it does after clicks.
    const taken = draft[draft.side].some((use) => use.piece === piece.id && use.edge === edge);
    if (taken && (event as KeyboardEvent).key === 'Enter') void pattern.finishSide();
    else pattern.sewEdge(piece.id, edge);
  };
  const lightEdge = (edge: string | null): void => {
    const [first] = edge === null ? [] : seamsOfEdge(pieces.seams, piece.id, edge);
    pattern.lightSeam(first === undefined ? null : pieces.seams[first]!.id);
  };
  const insert = (edgeId: string, event: MouseEvent): void => {
    const edge = piece.edges.find((other) => other.id === edgeId);
    if (tool !== 'points' || !edge) return;
    const { at } = nearestOn(edge, minus(worldOf(event), offset));
    void pattern.edit({ edit: 'insert_point', piece: piece.id, edge: edgeId, at });
  };
  return (
    <g onPointerDown={(event) => tool !== 'sew' && hands.pressPiece(piece.id, event)}>
      <PieceShape
        placed={placed}
        scale={scale}
        selected={selected}
        hovered={state.hovered.value === piece.id}
        look={state.looks.value.get(piece.id) ?? null}
        onSelect={click}
        onHover={(on) => commands.hover(on ? piece.id : null)}
      >
        <SeamShapes
          shown={seams}
          piece={piece.id}
          scale={scale}
          lit={lit}
          onLight={(seam) => pattern.lightSeam(seam)}
          onSelect={tool === 'pieces' ? (seam) => pattern.selectSeam(seam) : null}
        />
        <EditMarks
          piece={piece}
          scale={scale}
          tool={tool}
          open={tool === 'points' && selected}
          part={state.editing.part.value}
          draft={draft}
          draftColour={pieces.seams.length}
          onEdge={pressEdge}
          onLight={lightEdge}
          onInsert={insert}
          onGrab={hands.grab}
          onNudge={hands.nudge}
        />
      </PieceShape>
    </g>
  );
}

/** Lines to the points that the held one is in line with. */
function Guides({ held, placed }: { held: Held | null; placed: readonly PlacedPiece[] }) {
  if (held?.kind !== 'part') return null;
  const [dx, dy] = placed.find((one) => one.piece.id === held.piece)?.offset ?? [0, 0];
  return (
    <g class="guides" transform={`translate(${dx} ${-dy})`} aria-hidden="true">
      {held.guides.map(([x, y], i) => (
        <path key={i} d={`M${x} ${-y}L${held.to[0]} ${-held.to[1]}`} />
      ))}
    </g>
  );
}

/** What the hand or the pointer is at, in figures. */
function Note({ pieces, held, lit }: { pieces: Pieces; held: Held | null; lit: ShownSeam | null }) {
  const state = useAppState();
  const { problem, tool, draft } = state.editing;
  if (problem.value) {
    return (
      <div class="pattern-note bad" role="alert">
        <p>{sentence(problem.value.detail)}</p>
        <p class="code">{[problem.value.code, problem.value.where].filter(Boolean).join(' · ')}</p>
      </div>
    );
  }
  if (held?.kind === 'part') {
    return (
      <p class="pattern-note" role="status">
        <b>{held.to[0].toFixed(1)}</b>, <b>{held.to[1].toFixed(1)}</b> mm
      </p>
    );
  }
  if (lit && lit.seam.b.length > 0) {
    const { a, b } = seamLengths(pieces.pieces, lit.seam);
    const { lengths, difference } = lengthsText(a, b);
    return (
      <p class="pattern-note" role="status">
        <b>{lit.seam.id === kDraft ? 'New seam' : `${lit.index + 1} ${lit.seam.id}`}</b> {lengths} · {difference}
      </p>
    );
  }
  if (tool.value === 'sew') {
    const side = draft.value.side === 'a' || draft.value.a.length === 0 ? 'one side' : 'the other side';
    return (
      <p class="pattern-note" role="status">
        Click the edges of {side}, then press <kbd>Enter</kbd>
      </p>
    );
  }
  if (tool.value === 'points' && state.selected.value === null) {
    return (
      <p class="pattern-note" role="status">
        Click a piece to see its points
      </p>
    );
  }
  return null;
}

/** Squares of 10 cm behind the pieces, of 1 cm when near. */
function Paper({ scale }: { scale: number }) {
  const cell = scale > 1.2 ? 10 : 100;
  return (
    <>
      <defs>
        <pattern id="paper" width={cell} height={cell} patternUnits="userSpaceOnUse">
          <path class="paper-line" d={`M${cell} 0H0V${cell}`} stroke-width={1 / scale} />
        </pattern>
      </defs>
      <rect class="paper" x={-1e5} y={-1e5} width={2e5} height={2e5} fill="url(#paper)" />
    </>
  );
}
