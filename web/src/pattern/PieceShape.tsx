// One flat piece: cloth, outline, inner lines, notches, grain arrow, name and size. Its seams and what can be taken hold of
// are drawn over it by others.

import { useId } from 'preact/hooks';
import type { Notch, Piece, Point } from '../api/types';
import { piecePath } from '../state/outline';
import type { PlacedPiece } from '../state/layout';
import { boxOf, cssColour, spanAt, type Box } from '../state/patternGeometry';
import { patternTransform, type Look } from '../state/texture';
import { t } from '../texts/language';
import { patternFigure, patternLength } from '../texts/units';

export interface PieceShapeProps {
  placed: PlacedPiece;
  scale: number;
  selected: boolean;
  hovered: boolean;
  /** The picture on it. */
  look?: Look | null;
  /** What lies over cloth and picture, below outline and names. */
  cover?: preact.ComponentChildren;
  onSelect(): void;
  onHover(on: boolean): void;
  children?: preact.ComponentChildren;
}

export const linePath = (points: readonly Point[], closed = false): string =>
  points.map(([x, y], i) => `${i === 0 ? 'M' : 'L'}${x.toFixed(2)} ${(-y).toFixed(2)}`).join('') + (closed ? 'Z' : '');

/** Smallest piece, in pixels across, that still has its name and its size written on it. */
const kNamePx = 34;
const kSizePx = 120;
/** About the width of a letter of the name, and of one that is a capital. */
const kLetterPx = 7;
const kCapitalPx = 8.5;
export const widthOfName = (name: string): number =>
  [...name].reduce((sum, letter) => sum + (letter === letter.toLowerCase() ? kLetterPx : kCapitalPx), 0);
/** So many letters of a name that is cut off still tell it. */
const kTelling = 7;

/** Of the letters that are left, so many are the name's beginning: its end tells panel_3 from panel_4. */
const kBeginning = 0.6;

function cutTo(name: string, letters: number): string {
  const head = Math.ceil(kBeginning * letters);
  return `${name.slice(0, head)}…${name.slice(name.length - (letters - head))}`;
}

/** As much of a name as fits; nothing when that would be no name any more. */
export function nameThatFits(name: string, px: number): string {
  if (widthOfName(name) <= px) return name;
  let letters = name.length - 1;
  while (letters > 0 && widthOfName(cutTo(name, letters)) > px) --letters;
  return letters >= kTelling ? cutTo(name, letters) : '';
}

export function PieceShape(props: PieceShapeProps) {
  const { placed, scale, selected, hovered, look = null, cover, onSelect, onHover, children } = props;
  const { piece, offset } = placed;
  const press = (event: KeyboardEvent): void => {
    if ((event.key !== 'Enter' && event.key !== ' ')) return;
    event.preventDefault();
    event.stopPropagation();
    onSelect();
  };
  const size = sizeText(piece);
  const outline = piecePath(piece);
  return (
    <g
      class={`piece${selected ? ' selected' : ''}${hovered ? ' hovered' : ''}${look || cover ? ' printed' : ''}`}
      style={{ '--halo': `${3 / scale}px` }}
      transform={`translate(${offset[0]} ${-offset[1]})`}
      data-piece={piece.id}
      onPointerEnter={() => onHover(true)}
      onPointerLeave={() => onHover(false)}
    >
      <title>{`${piece.id}, ${size}`}</title>
      <path
        class="piece-cloth"
        tabindex={0}
        role="button"
        aria-pressed={selected}
        aria-label={t.pattern.pieceLabel(piece.id, size)}
        onKeyDown={press}
        fill-rule="evenodd"
        style={{ fill: cssColour(piece.colour) }}
        d={outline}
      />
      {look && <Print piece={piece} look={look} outline={outline} />}
      {cover}
      <path class="piece-outline" fill="none" d={outline} />
      {piece.lines.map((line) => (
        <path key={line.id} class={line.drawn ? 'piece-line drawn' : 'piece-line'} d={linePath(line.points)}>
          <title>{line.id}</title>
        </path>
      ))}
      {piece.notches.map((notch, i) => (
        <NotchMark key={i} notch={notch} piece={piece} scale={scale} />
      ))}
      <Label placed={placed} scale={scale} />
      {children}
    </g>
  );
}

export function sizeText({ outline }: Piece): string {
  const box = boxOf(outline);
  return `${patternFigure(box.maxX - box.minX, 0)} × ${patternLength(box.maxY - box.minY, 0)}`;
}

/** As much of its name as is written on a piece. */
export function nameOn(placed: PlacedPiece, scale: number): string {
  const { piece } = placed;
  const box = boxOf(piece.outline);
  if (Math.min(box.maxX - box.minX, 2.2 * (box.maxY - box.minY)) * scale <= kNamePx) return '';
  return nameThatFits(piece.id, spanAt(piece.outline, labelAt(placed)) * scale - 6);
}

/** The grain's arrow, the name and the size, as far as there is room for them. */
function Label({ placed, scale }: { placed: PlacedPiece; scale: number }) {
  const { piece } = placed;
  const box = boxOf(piece.outline);
  const across = (box.maxX - box.minX) * scale;
  const down = (box.maxY - box.minY) * scale;
  const at = labelAt(placed);
  const name = nameOn(placed, scale);
  return (
    <>
      {piece.grain && Math.min(across, down) > kNamePx && (
        <Grain at={at} along={piece.grain} box={box} scale={scale} down={down} name={widthOfName(name)} />
      )}
      {name !== '' && (
        <text class="piece-name" x={at[0]} y={-at[1]} font-size={12 / scale} dy={down > kSizePx ? '-0.2em' : '0.35em'}>
          {name}
        </text>
      )}
      {across > kSizePx && down > kSizePx && (
        <text class="piece-size" x={at[0]} y={-at[1]} font-size={10.5 / scale} dy="1.15em">
          {sizeText(piece)}
        </text>
      )}
    </>
  );
}

/** The piece's picture, repeated over it in its own size. */
function Print({ piece, look, outline }: { piece: Piece; look: Look; outline: string }) {
  const id = useId();
  const { texture, picture } = look;
  const width = texture.scale_mm;
  const height = (width * picture.height) / picture.width;
  return (
    <>
      <defs>
        <pattern
          id={id}
          width={width}
          height={height}
          patternUnits="userSpaceOnUse"
          patternTransform={patternTransform(piece.grain, texture)}
        >
          <image href={picture.url} width={width} height={height} preserveAspectRatio="none" />
        </pattern>
      </defs>
      <path class="piece-print" fill-rule="evenodd" fill={`url(#${id})`} d={outline} />
    </>
  );
}

const labelAt = ({ centre, offset }: PlacedPiece): Point => [centre[0] - offset[0], centre[1] - offset[1]];

/** A tick from the outline inwards; of its own depth where that is told and can be seen. */
function NotchMark({ notch, piece, scale }: { notch: Notch; piece: Piece; scale: number }) {
  const [dx, dy] = notch.inwards ?? inwards(piece, notch.at);
  const long = Math.max(Math.abs(notch.depth_mm), 7 / scale);
  const [x, y] = notch.at;
  return <path class="notch" d={`M${x} ${-y}L${x + dx * long} ${-(y + dy * long)}`} />;
}

/** Across the outline at a point, towards the cloth: outlines run counter-clockwise. */
function inwards(piece: Piece, at: Point): Point {
  let best: Point = [0, 1];
  let nearest = Infinity;
  piece.outline.forEach(([x0, y0], i) => {
    const [x1, y1] = piece.outline[(i + 1) % piece.outline.length]!;
    const far = Math.hypot((x0 + x1) / 2 - at[0], (y0 + y1) / 2 - at[1]);
    const long = Math.hypot(x1 - x0, y1 - y0);
    if (far >= nearest || long === 0) return;
    nearest = far;
    best = [-(y1 - y0) / long, (x1 - x0) / long];
  });
  return best;
}

interface GrainProps {
  at: Point;
  along: Point;
  box: Box;
  scale: number;
  down: number;
  /** Width of the piece's name, px. */
  name: number;
}

/** A double-headed arrow along the warp: through the name's place with a gap for it, or beside it where a piece is low. */
function Grain({ at, along, box, scale, down, name }: GrainProps) {
  const length = Math.hypot(along[0], along[1]) || 1;
  const [ux, uy] = [along[0] / length, along[1] / length];
  const high = down > kSizePx;
  const room = Math.abs(uy) * (box.maxY - box.minY) + Math.abs(ux) * (box.maxX - box.minX);
  // Inside of the piece's box also where the name does not stand in its middle.
  const upright = Math.abs(uy) > 0.5;
  const ahead = upright ? Math.min(at[1] - box.minY, box.maxY - at[1]) - 6 / scale : Infinity;
  const half = Math.min(room * 0.36, 90 / scale, ahead);
  const aside = high ? 0 : (name / 2 + 14) / scale;
  if (at[0] + aside > box.maxX - 8 / scale) return null;
  const degrees = (Math.atan2(-uy, ux) * 180) / Math.PI;
  const head = Math.min(6 / scale, half * 0.6);
  // Across the name the gap is as long as the name, along it as high.
  const gap = high ? (upright ? 24 : name / 2 + 8) / scale : 0;
  if (half < Math.max(gap * 1.2, 10 / scale)) return null;
  const ends = [
    `M${-half} 0H${-gap}M${gap} 0H${half}`,
    `M${-half + head} ${-head * 0.6}L${-half} 0L${-half + head} ${head * 0.6}`,
    `M${half - head} ${-head * 0.6}L${half} 0L${half - head} ${head * 0.6}`,
  ];
  return (
    <g
      class="grain"
      transform={`translate(${at[0] + aside} ${-at[1]}) rotate(${degrees})`}
      stroke-width={1.25 / scale}
      aria-hidden="true"
    >
      <path d={ends.join('')} />
    </g>
  );
}
