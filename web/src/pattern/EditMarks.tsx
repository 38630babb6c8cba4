// What can be taken hold of on a piece: its edges, and with the points tool the corners, points and handles of the one that
// is selected.

import type { Piece, PieceEdge, Point } from '../api/types';
import type { Part, Tool } from '../state/editing';
import { isStraight, jointsOf } from '../state/outline';
import { seamColour, type SeamDraft } from '../state/seamView';
import { linePath } from './PieceShape';

export interface EditMarksProps {
  piece: Piece;
  scale: number;
  tool: Tool;
  /** Whether points and handles are shown. */
  open: boolean;
  part: Part | null;
  draft: SeamDraft;
  draftColour: number;
  onEdge(edge: string, event: PointerEvent | KeyboardEvent): void;
  onInsert(edge: string, event: MouseEvent): void;
  /** Under the pointer; null when it leaves. */
  onLight(edge: string | null): void;
  onGrab(part: Part, at: Point, event: PointerEvent): void;
  onNudge(part: Part, at: Point, by: Point): void;
}

export function EditMarks(props: EditMarksProps) {
  const { piece, tool, open, part, draft, draftColour } = props;
  return (
    <>
      {tool !== 'pieces' &&
        piece.edges.map((edge) => {
          const chosen = part?.kind === 'edge' && part.piece === piece.id && part.edge === edge.id;
          const side = (['a', 'b'] as const).find((s) =>
            draft[s].some((use) => use.piece === piece.id && use.edge === edge.id),
          );
          return (
            <g
              key={`${edge.loop} ${edge.id}`}
              class={`edge${chosen ? ' chosen' : ''}${side ? ` side-${side}` : ''}`}
              style={{ '--seam': seamColour(draftColour) }}
              data-edge={edge.id}
              tabindex={open || tool === 'sew' ? 0 : -1}
              role="button"
              aria-pressed={chosen || side !== undefined}
              aria-label={`Edge ${edge.id} of ${piece.id}, ${edge.length_mm.toFixed(1)} mm${side ? `, side ${side.toUpperCase()}` : ''}`}
              onPointerDown={(event) => props.onEdge(edge.id, event)}
              onPointerEnter={() => props.onLight(edge.id)}
              onPointerLeave={() => props.onLight(null)}
              onDblClick={(event) => props.onInsert(edge.id, event)}
              onKeyDown={(event) => {
                if (event.key !== 'Enter' && event.key !== ' ') return;
                event.preventDefault();
                event.stopPropagation();
                props.onEdge(edge.id, event);
              }}
            >
              <path class="edge-catch" d={linePath(edge.points)} />
              <path class="edge-line" d={linePath(edge.points)} />
            </g>
          );
        })}
      {open && piece.edges.map((edge) => <EdgePoints key={`${edge.loop} ${edge.id}`} edge={edge} {...props} />)}
    </>
  );
}

/** Handles first, so that points lie over them. An edge's last point is the first of the next. */
function EdgePoints({ edge, ...props }: EditMarksProps & { edge: PieceEdge }) {
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
                name={`Handle ${handle} of curve ${i + 1} of edge ${edge.id}`}
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
          name={point === 0 ? `Corner at the start of edge ${edge.id}` : `Point ${point} of edge ${edge.id}`}
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
  const chosen = JSON.stringify(part) === JSON.stringify(held);
  const corner = part.kind === 'point' && part.point === 0;
  const keys = (event: KeyboardEvent): void => {
    const step = kSteps[event.key];
    if (event.key === 'Enter' || event.key === ' ') onGrab(part, at, event as unknown as PointerEvent);
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
      aria-label={`${name} at ${at[0].toFixed(1)}, ${at[1].toFixed(1)} mm; arrow keys move it`}
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
