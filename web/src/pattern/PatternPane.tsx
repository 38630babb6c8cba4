// The flat pieces beside the 3D view: pan, zoom, fit; names, sizes, grain; seams in pairs of one colour; selecting, editing
// and sewing by hand.

import { useComputed, useSignalEffect, type ReadonlySignal } from '@preact/signals';
import type { Piece, Pieces, SeamSides } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { layOut, type PlacedPiece } from '../state/layout';
import { add } from '../state/outline';
import { seamParts, type SeamDraft } from '../state/seamView';
import { draftShown } from '../state/editing';
import { toolOf } from '../tools/table';
import type { Held, PatternTool } from '../tools/PatternTool';
import { PatternNote } from './PatternNote';
import { PatternTools } from './PatternTools';
import { PieceTags } from './PieceTags';
import { PlacedPieceView } from './PlacedPieceView';
import { kDraftSeam, Threads, type ShownSeam } from './SeamShapes';
import { RangeMarks } from './RangeMarks';
import { useHands, type Hands } from './useHands';
import { usePlaneFrame, usePlaneView, type PlaneFrame, type PlaneView } from './usePlaneView';
import { roomWithin } from './Viewport';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

/** Where the tool that is held wants other cursors, as the style sheet looks for them. */
const cursorsOf = ({ cursor = {} }: PatternTool): Record<string, string | undefined> => ({
  '--on-paper': cursor.paper,
  '--on-piece': cursor.piece,
  '--on-selected': cursor.selected,
});

export function PatternPane() {
  const state = useAppState();
  const pieces = state.pieces.value;
  const tool = toolOf(state.editing.tool.value);
  return (
    <section class={`pattern${tool.edges ? ' edges-open' : ''}`} style={cursorsOf(tool)} aria-label={t.pattern.title}>
      {pieces === null && <p class="hint">{t.pattern.appearHere}</p>}
      {pieces?.state === 'loading' && (
        <div class="skeleton-pieces" role="status" aria-label={t.pattern.loading}>
          <i />
          <i />
          <i />
          <i />
        </div>
      )}
      {pieces?.state === 'failed' && (
        <div class="pane-error" role="alert">
          <h3>{t.pattern.cannotShow}</h3>
          <p>
            <Told code={pieces.error.code} detail={pieces.error.detail} />
          </p>
          <p class="code">
            {pieces.error.code}
            {pieces.error.where && <> · {pieces.error.where}</>}
          </p>
        </div>
      )}
      {pieces?.state === 'ready' && <Plane pieces={pieces.value} tool={tool} />}
    </section>
  );
}

/** Where the pieces lie; one that has been shown keeps its place while others come and go. */
function usePlaces({ size, rim }: PlaneFrame): ReadonlySignal<PlacedPiece[]> {
  const state = useAppState();
  const { offsets } = state.editing;
  const placed = useComputed(() => layOut(state.sewn.value.pieces, roomWithin(size.value, rim.value), offsets.value));
  useSignalEffect(() => {
    const next = new Map(placed.value.map((one) => [one.piece.id, one.offset]));
    const known = offsets.peek();
    if ([...next.keys()].some((id) => !known.has(id))) offsets.value = new Map([...known, ...next]);
  });
  return placed;
}

function Plane({ pieces, tool }: { pieces: Pieces; tool: PatternTool }) {
  const state = useAppState();
  const commands = useCommands();
  const frame = usePlaneFrame();
  const placed = usePlaces(frame);
  const plane = usePlaneView(
    frame,
    () => placed.value.map((piece) => piece.box),
    () => state.projectId.value,
  );
  const hands = useHands({ hand: { state, commands }, tool, view: () => plane.view.value, move: plane.move, worldOf: plane.worldOf });
  const { held } = hands;
  const shown = pieces.pieces.map((piece) => (held?.piece === piece.id ? held.shown(piece) : piece));
  const sewn = { ...pieces, pieces: shown };
  const seams = useSeams(sewn);
  return (
    <>
      <Sheet pieces={pieces} places={placedAs(placed.value, shown, held)} {...{ tool, plane, hands, seams }} />
      <PatternTools />
      <ViewButtons plane={plane} />
      <PatternNote pieces={sewn} tool={tool} held={held} lit={seams.lit} />
    </>
  );
}

/** The pieces as they are shown, where the hand has them. */
function placedAs(placed: readonly PlacedPiece[], shown: readonly Piece[], held: Held | null): PlacedPiece[] {
  return placed.map((one) => {
    const piece = shown.find((other) => other.id === one.piece.id) ?? one.piece;
    if (held?.piece !== piece.id) return { ...one, piece };
    const offset = add(one.offset, held.by);
    return { ...one, piece, offset, centre: add(one.centre, held.by) };
  });
}

interface SheetProps {
  pieces: Pieces;
  places: readonly PlacedPiece[];
  tool: PatternTool;
  plane: PlaneView;
  hands: Hands;
  seams: Seams;
}

/** The paper with everything that lies on it. */
function Sheet({ pieces, places, tool, plane, hands, seams }: SheetProps) {
  const state = useAppState();
  const { scale } = plane.view.value;
  return (
    <svg
      ref={plane.svg}
      class="plane"
      tabindex={0}
      viewBox={plane.viewBox}
      onWheel={plane.wheel}
      onKeyDown={plane.keys}
      {...hands.plane}
      aria-label={t.pattern.sheet(places.length)}
      role="group"
    >
      <Paper scale={scale} />
      {places.map((one) => (
        <PlacedPieceView
          key={one.piece.id}
          placed={one}
          known={pieces.seams}
          seams={seams.all}
          lit={seams.litId}
          scale={scale}
          tool={tool}
          hands={hands}
          worldOf={plane.worldOf}
        />
      ))}
      {seams.lit && <Threads shown={seams.lit} placed={places} scale={scale} />}
      <Guides held={hands.held} placed={places} />
      <PieceTags placed={places} told={[state.selected.value, state.hovered.value]} scale={scale} seen={plane.seen} />
      <RangeMarks placed={places} scale={scale} colour={pieces.seams.length} />
    </svg>
  );
}

function ViewButtons({ plane }: { plane: PlaneView }) {
  return (
    <div class="plane-tools" role="toolbar" aria-label={t.pattern.view}>
      <button class="tool" title={t.pattern.zoomOutKey} aria-label={t.pattern.zoomOut} onClick={() => plane.zoom(0.8)}>
        −
      </button>
      <button class="tool wide" title={t.pattern.fitKey} onClick={plane.fitAll}>
        {t.pattern.fit}
      </button>
      <button class="tool" title={t.pattern.zoomInKey} aria-label={t.pattern.zoomIn} onClick={() => plane.zoom(1.25)}>
        +
      </button>
    </div>
  );
}

/** Lines to the points that the held one is in line with. */
function Guides({ held, placed }: { held: Held | null; placed: readonly PlacedPiece[] }) {
  if (!held?.at) return null;
  const [atX, atY] = held.at;
  const [dx, dy] = placed.find((one) => one.piece.id === held.piece)?.offset ?? [0, 0];
  return (
    <g class="guides" transform={`translate(${dx} ${-dy})`} aria-hidden="true">
      {held.guides.map(([x, y], i) => (
        <path key={i} d={`M${x} ${-y}L${atX} ${-atY}`} />
      ))}
    </g>
  );
}

interface Seams {
  all: ShownSeam[];
  /** Of the one that the others stand back behind. */
  litId: string | null;
  lit: ShownSeam | null;
}

/** All seams with the one that is being made, which is lit before any other. */
function useSeams(pieces: Pieces): Seams {
  const { editing } = useAppState();
  const proposal = editing.litProposal.value;
  const all = seamsShown(pieces, draftShown(editing, pieces.pieces), proposal);
  const drafted = all.some((one) => one.seam.id === kDraftSeam);
  const litId = drafted ? kDraftSeam : (proposal?.id ?? editing.litSeam.value ?? editing.seam.value);
  return { all, litId, lit: all.find((one) => one.seam.id === litId) ?? null };
}

function seamsShown({ pieces, seams }: Pieces, draft: SeamDraft, proposal: SeamSides | null): ShownSeam[] {
  const all: SeamSides[] = proposal ? [...seams, proposal] : [...seams];
  if (draft.a.length > 0) all.push({ id: kDraftSeam, a: draft.a, b: draft.b, same_direction: draft.sameDirection });
  return all.map((seam, index) => ({ seam, index, parts: seamParts(pieces, seam) }));
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
