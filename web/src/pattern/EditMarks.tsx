// What can be taken hold of on a piece: its edges, and with the points tool the corners, points and handles of the one that
// is selected.

import type { Piece, PieceEdge, Point } from '../api/types';
import { samePart, type Part } from '../state/editing';
import { isStraight, jointsOf } from '../state/outline';
import { edgeTitles } from '../state/seamNames';
import { seamColour, type SeamDraft } from '../state/seamView';
import type { PatternTool } from '../tools/PatternTool';
import { linePath } from './PieceShape';
import { t } from '../texts/language';
import { patternFigure, patternLength } from '../texts/units';

export interface EditMarksProps {
  piece: Piece;
  scale: number;
  tool: PatternTool;
  selected: boolean;
  part: Part | null;
  draft: SeamDraft;
  draftColour: number;
  onEdge(edge: string, event: PointerEvent | KeyboardEvent): void;
  onInsert(edge: string, event: MouseEvent): void;
  /** Under the pointer; null when it leaves. */
  onLight(edge: string | null): void;
  onGrab(part: Part, at: Point, event: PointerEvent | KeyboardEvent): void;
  onNudge(part: Part, at: Point, by: Point): void;
}

export function EditMarks(props: EditMarksProps) {
  const { piece, tool, selected } = props;
  const titles = edgeTitles(piece);
  const titleOf = (edge: PieceEdge): string => titles.get(edge.id) ?? edge.id;
  return (
    <>
      {tool.edges && piece.edges.map((edge) => <EdgeMark key={`${edge.loop} ${edge.id}`} {...props} edge={edge} title={titleOf(edge)} />)}
      {tool.grab &&
        selected &&
        piece.edges.map((edge) => <EdgePoints key={`${edge.loop} ${edge.id}`} {...props} edge={edge} title={titleOf(edge)} />)}
    </>
  );
}

interface EdgeProps extends EditMarksProps {
  edge: PieceEdge;
  /** As a person calls it. */
  title: string;
}

/** The side of the seam that is being made which has all of this edge. */
const sideOf = (draft: SeamDraft, piece: string, edge: string): 'a' | 'b' | undefined =>
  (['a', 'b'] as const).find((side) =>
    draft[side].some(({ from = 0, to = 1, ...use }) => use.piece === piece && use.edge === edge && to - from === 1),
  );

function EdgeMark({ edge, title, ...props }: EdgeProps) {
  const { piece, tool, selected, part, draft, draftColour } = props;
  const chosen = part?.kind === 'edge' && part.piece === piece.id && part.edge === edge.id;
  const side = sideOf(draft, piece.id, edge.id);
  const keys = (event: KeyboardEvent): void => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    event.stopPropagation();
    props.onEdge(edge.id, event);
  };
  return (
    <g
      class={`edge${chosen ? ' chosen' : ''}${side ? ` side-${side}` : ''}`}
      style={{ '--seam': seamColour(draftColour) }}
      data-edge={edge.id}
      tabindex={selected || tool.edges?.tabbed === 'all' ? 0 : -1}
      role="button"
      aria-pressed={chosen || side !== undefined}
      aria-label={`${t.pattern.edgeLabel(title, piece.id, patternLength(edge.length_mm))}${side ? t.pattern.sideLabel(side.toUpperCase()) : ''}`}
      onPointerDown={(event) => props.onEdge(edge.id, event)}
      onPointerEnter={() => props.onLight(edge.id)}
      onPointerLeave={() => props.onLight(null)}
      onDblClick={(event) => props.onInsert(edge.id, event)}
      onKeyDown={keys}
    >
      <path class="edge-catch" d={linePath(edge.points)} />
      <path class="edge-line" d={linePath(edge.points)} />
    </g>
  );
}

/** Handles first, so that points lie over them. An edge's last point is the first of the next. */
function EdgePoints({ edge, title, ...props }: EdgeProps) {
  const { piece, part } = props;
  const joints = jointsOf(edge).slice(0, -1);
  const shown = part !== null && part.piece === piece.id && part.edge === edge.id;
  return (
    <>
      {edge.curves.map((curve, i) =>
        isStraight(curve) && !shown
          ? null
          : ([1, 2] as const).map((handle) => (
              <Grip
                key={`${i} ${handle}`}
                {...props}
                part={{ kind: 'handle', piece: piece.id, edge: edge.id, curve: i, handle }}
                held={part}
                at={curve[handle]}
                from={curve[handle === 1 ? 0 : 3]}
                name={t.pattern.handleName(handle, i + 1, title)}
              />
            )),
      )}
      {joints.map((at, point) => (
        <Grip
          key={point}
          {...props}
          part={{ kind: 'point', piece: piece.id, edge: edge.id, point }}
          held={part}
          at={at}
          from={null}
          name={point === 0 ? t.pattern.cornerName(title) : t.pattern.pointName(point, title)}
        />
      ))}
    </>
  );
}

const kSteps: Record<string, Point> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

function Grip({
  part,
  held,
  at,
  from,
  name,
  scale,
  onGrab,
  onNudge,
}: Pick<EditMarksProps, 'scale' | 'onGrab' | 'onNudge'> & {
  part: Part;
  held: Part | null;
  at: Point;
  from: Point | null;
  name: string;
}) {
  const chosen = samePart(part, held);
  const corner = part.kind === 'point' && part.point === 0;
  const keys = (event: KeyboardEvent): void => {
    const step = kSteps[event.key];
    if (event.key === 'Enter' || event.key === ' ') onGrab(part, at, event);
    else if (step) onNudge(part, at, event.shiftKey ? [step[0] * 10, step[1] * 10] : step);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <g
      class={`grip ${part.kind}${chosen ? ' chosen' : ''}`}
      tabindex={0}
      role="button"
      aria-pressed={chosen}
      aria-label={t.pattern.gripLabel(name, `${patternFigure(at[0])}, ${patternLength(at[1])}`)}
      onPointerDown={(event) => onGrab(part, at, event)}
      onKeyDown={keys}
    >
      {from && <path class="grip-arm" d={linePath([from, at])} />}
      <g transform={`translate(${at[0]} ${-at[1]}) scale(${1 / scale})`}>
        <circle class="grip-catch" r={12} />
        {part.kind === 'handle' ? (
          <circle class="grip-dot" r={4} />
        ) : corner ? (
          <rect class="grip-dot" x={-4.5} y={-4.5} width={9} height={9} rx={1} />
        ) : (
          <circle class="grip-dot" r={4.5} />
        )}
      </g>
    </g>
  );
}
