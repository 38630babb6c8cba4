// One flat piece: outline, holes, seams, grain arrow, name and size.

import type { Point } from '../api/types';
import { boxOf, cssColour, lengthOf, seamHue, type PlacedPiece, type SeamLine } from '../state/patternGeometry';

export interface PieceShapeProps {
  placed: PlacedPiece;
  lines: SeamLine[];
  scale: number;
  selected: boolean;
  hovered: boolean;
  /** Seam that is lit up. */
  seam: string | null;
  onSelect(): void;
  onHover(on: boolean): void;
  onSeam(seam: string | null): void;
}

const path = (points: readonly Point[], closed: boolean): string =>
  points.map(([x, y], i) => `${i === 0 ? 'M' : 'L'}${x.toFixed(2)} ${(-y).toFixed(2)}`).join('') + (closed ? 'Z' : '');

/** Smallest piece, in pixels across, that still has its name and its size written on it. */
const kNamePx = 34;
const kSizePx = 120;

export function PieceShape(props: PieceShapeProps) {
  const { placed, lines, scale, selected, hovered, seam, onSelect, onHover, onSeam } = props;
  const { piece, offset } = placed;
  const box = boxOf(piece.outline);
  const across = (box.maxX - box.minX) * scale,
    down = (box.maxY - box.minY) * scale;
  const press = (event: KeyboardEvent): void => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    event.stopPropagation();
    onSelect();
  };
  const size = `${Math.round(box.maxX - box.minX)} × ${Math.round(box.maxY - box.minY)} mm`;
  return (
    <g
      class={`piece${selected ? ' selected' : ''}${hovered ? ' hovered' : ''}`}
      transform={`translate(${offset[0]} ${-offset[1]})`}
      tabindex={0}
      role="button"
      aria-pressed={selected}
      aria-label={`Piece ${piece.id}, ${size}`}
      data-piece={piece.id}
      onClick={onSelect}
      onKeyDown={press}
      onPointerEnter={() => onHover(true)}
      onPointerLeave={() => onHover(false)}
    >
      <path
        class="piece-cloth"
        fill-rule="evenodd"
        style={{ fill: cssColour(piece.colour) }}
        d={path(piece.outline, true) + piece.holes.map((hole) => path(hole, true)).join('')}
      />
      <path
        class="piece-outline"
        fill="none"
        d={path(piece.outline, true) + piece.holes.map((hole) => path(hole, true)).join('')}
      />
      {lines.map((line, i) => (
        <SeamMark key={i} line={line} scale={scale} lit={seam === line.seam} onSeam={onSeam} />
      ))}
      {piece.grain && Math.min(across, down) > kNamePx && (
        <Grain at={labelAt(placed)} along={piece.grain} box={box} scale={scale} down={down} />
      )}
      {Math.min(across, down * 2.2) > kNamePx && (
        <text
          class="piece-name"
          x={labelAt(placed)[0]}
          y={-labelAt(placed)[1]}
          font-size={12 / scale}
          dy={down > kSizePx ? '-0.2em' : '0.35em'}
        >
          {piece.id}
        </text>
      )}
      {across > kSizePx && down > kSizePx && (
        <text class="piece-size" x={labelAt(placed)[0]} y={-labelAt(placed)[1]} font-size={10.5 / scale} dy="1.15em">
          {size}
        </text>
      )}
    </g>
  );
}

const labelAt = ({ centre, offset }: PlacedPiece): Point => [centre[0] - offset[0], centre[1] - offset[1]];

/** The sewn edge in its seam's colour; under it a wider one that the pointer finds. */
function SeamMark({
  line,
  scale,
  lit,
  onSeam,
}: {
  line: SeamLine;
  scale: number;
  lit: boolean;
  onSeam(seam: string | null): void;
}) {
  const colour = { '--hue': String(seamHue(line.index)) };
  return (
    <g
      class={`seam${lit ? ' lit' : ''}`}
      style={colour}
      onPointerEnter={() => onSeam(line.seam)}
      onPointerLeave={() => onSeam(null)}
    >
      <title>{`${line.seam} · ${Math.round(lengthOf(line.points))} mm`}</title>
      <path class="seam-catch" d={path(line.points, false)} stroke-width={12 / scale} />
      <path class="seam-line" d={path(line.points, false)} stroke-width={(lit ? 5 : 3) / scale} />
    </g>
  );
}

/** A double-headed arrow along the warp, beside the name. */
function Grain({
  at,
  along,
  box,
  scale,
  down,
}: {
  at: Point;
  along: Point;
  box: ReturnType<typeof boxOf>;
  scale: number;
  down: number;
}) {
  const length = Math.hypot(along[0], along[1]) || 1;
  const [ux, uy] = [along[0] / length, along[1] / length];
  const room = Math.abs(uy) * (box.maxY - box.minY) + Math.abs(ux) * (box.maxX - box.minX);
  const half = Math.min(room * 0.36, 90 / scale);
  const beside = down > kSizePx ? 0 : 34 / scale;
  const x = at[0] + uy * beside,
    y = -(at[1] - ux * beside);
  const degrees = (Math.atan2(-uy, ux) * 180) / Math.PI;
  const head = Math.min(6 / scale, half * 0.6);
  const gap = down > kSizePx ? 24 / scale : 0;
  if (half < gap * 1.2) return null;
  return (
    <g
      class="grain"
      transform={`translate(${x} ${y}) rotate(${degrees})`}
      stroke-width={1.25 / scale}
      aria-hidden="true"
    >
      <path
        d={`M${-half} 0H${-gap}M${gap} 0H${half}M${-half + head} ${-head * 0.6}L${-half} 0L${-half + head} ${head * 0.6}M${half - head} ${-head * 0.6}L${half} 0L${half - head} ${head * 0.6}`}
      />
    </g>
  );
}
