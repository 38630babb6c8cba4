// The piece, edge or point that is selected, in figures, and what can be done with it.

import { useSignal } from '@preact/signals';
import type { Edit, Piece, PieceEdge, Pieces, Point } from '../api/types';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { findPart, type Part } from '../state/editing';
import { isStraight, nearestOn, nextEdge, notchAt } from '../state/outline';
import { boxOf, insideOf } from '../state/patternGeometry';
import { edgeTitles, edgeWords, seamTitle } from '../state/seamNames';
import { seamColour, seamsOfEdge } from '../state/seamView';
import { NumberField } from '../controls/NumberField';
import { points } from '../tools/points';
import { patternFigure, patternLength } from '../texts/units';
import { FabricField } from './FabricField';
import { TextureFields } from './TextureFields';
import { t } from '../texts/language';

export function SelectionPanel({ pieces }: { pieces: Pieces }) {
  const state = useAppState();
  const { pattern } = useCommands();
  const part = state.editing.part.value;
  const found = findPart(pieces.pieces, part);
  const piece = found?.piece ?? pieces.pieces.find((one) => one.id === state.selected.value);
  if (!piece) {
    return (
      <>
        <p class="hint">
          {t.pattern.selectHint} <b>{t.keys.tools.points.title}</b> {t.pattern.selectPoints}{' '}
          <b>{t.keys.tools.sew.title}</b> {t.pattern.selectSew}
        </p>
        <FabricField pieces={pieces.pieces} />
        <TextureFields pieces={pieces.pieces} all={pieces.pieces} />
      </>
    );
  }
  return (
    <section class="selection" aria-label={t.pattern.selection}>
      <NameField
        key={piece.id}
        label={t.pattern.pieceName}
        name={piece.id}
        take={(to) => void pattern.renamePiece(piece.id, to)}
      />
      {found && part ? (
        <>
          {part.kind !== 'edge' && found.at && (
            <PointFigures piece={piece} part={part} edge={found.edge} at={found.at} />
          )}
          <EdgeFigures piece={piece} edge={found.edge} pieces={pieces} part={part} />
        </>
      ) : (
        <PieceFigures piece={piece} all={pieces.pieces} />
      )}
    </section>
  );
}

/** A name that can be typed over. */
function NameField({ label, name, take }: { label: string; name: string; take(to: string): void }) {
  const typed = useSignal(name);
  const done = (): void => {
    const to = typed.value.trim();
    if (to === '') typed.value = name;
    else if (to !== name) take(to);
  };
  return (
    <label class="name-field">
      <span class="visually-hidden">{label}</span>
      <input
        value={typed.value}
        maxLength={200}
        spellcheck={false}
        title={t.pattern.renameTip(label)}
        onInput={(event) => (typed.value = event.currentTarget.value)}
        onBlur={done}
        onKeyDown={(event) => {
          if (event.key === 'Escape') typed.value = name;
          if (event.key === 'Enter' || event.key === 'Escape') event.currentTarget.blur();
        }}
      />
    </label>
  );
}

function PieceFigures({ piece, all }: { piece: Piece; all: readonly Piece[] }) {
  const commands = useCommands();
  const { edits, pattern } = commands;
  const box = boxOf(piece.outline);
  const grain = piece.grain ?? [0, 1];
  const move = (by: Point): Promise<void> => pattern.movePiece(piece.id, by);
  const angle = (Math.atan2(grain[1], grain[0]) * 180) / Math.PI;
  return (
    <>
      <p class="selection-facts">
        {patternFigure(box.maxX - box.minX)} × {patternLength(box.maxY - box.minY)} · {t.pattern.edgeCount(piece.edges.length)}
        {piece.notches.length > 0 && ` · ${t.pattern.notchCount(piece.notches.length)}`}
      </p>
      <div class="field-row">
        <NumberField
          label={t.pattern.grain}
          value={angle}
          unit="°"
          take={(wanted) => void edits.send({ edit: 'rotate_grain', piece: piece.id, angle: turn(wanted - angle) })}
        />
        <span class="field-pair">
          <NumberField label="x" value={box.minX} length take={(x) => void move([x - box.minX, 0])} />
          <NumberField label="y" value={box.minY} length take={(y) => void move([0, y - box.minY])} />
        </span>
      </div>
      <div class="button-row">
        <button class="plain" onClick={() => void edits.send({ edit: 'rotate_grain', piece: piece.id, angle: 45 })}>
          {t.pattern.grain45}
        </button>
        <button class="plain" onClick={() => void edits.send({ edit: 'mirror_piece', piece: piece.id })}>
          {t.pattern.mirror}
        </button>
        <button class="plain" onClick={() => void pattern.duplicatePiece(piece.id, false)}>
          {t.pattern.duplicate}
        </button>
        <button
          class="plain"
          title={t.pattern.mirroredTip}
          onClick={() => void pattern.duplicatePiece(piece.id, true)}
        >
          {t.pattern.mirrored}
        </button>
        <button class="plain danger" onClick={() => void pattern.removePiece(piece.id)}>
          {t.common.delete}
        </button>
      </div>
      <FabricField pieces={[piece]} />
      <TextureFields key={piece.id} pieces={[piece]} all={all} />
      <EdgeChips piece={piece} />
      <InnerDartFields piece={piece} />
    </>
  );
}

const turn = (degrees: number): number => Math.round((((degrees + 540) % 360) - 180) * 1000) / 1000;

/** Each edge as a button: the way to edges without a pointer. */
function EdgeChips({ piece }: { piece: Piece }) {
  const commands = useCommands();
  const pick = (edge: string): void => {
    commands.pattern.takeTool(points);
    commands.pattern.selectPart({ kind: 'edge', piece: piece.id, edge });
  };
  const titles = edgeTitles(piece);
  return (
    <ul class="edge-chips" aria-label={t.pattern.edgesOf(piece.id)}>
      {piece.edges.map((edge) => (
        <li key={`${edge.loop} ${edge.id}`}>
          <button class="part" title={patternLength(edge.length_mm)} onClick={() => pick(edge.id)}>
            {titles.get(edge.id)} <small>{patternFigure(edge.length_mm, 0)}</small>
          </button>
        </li>
      ))}
    </ul>
  );
}

/** Marks a point of the outline with a notch, or takes its notch away. */
function NotchButton({ piece, edge, at }: { piece: Piece; edge: PieceEdge; at: Point }) {
  const { edits } = useCommands();
  const notch = notchAt(piece, at);
  if (notch >= 0) {
    const remove: Edit = { edit: 'remove_notch', piece: piece.id, notch };
    return (
      <button class="plain" onClick={() => void edits.send(remove)}>
        {t.pattern.removeNotch}
      </button>
    );
  }
  const mark: Edit = { edit: 'add_notch', piece: piece.id, edge: edge.id, at: nearestOn(edge, at).at, depth_mm: 5 };
  return (
    <button class="plain" title={t.pattern.notchTip} onClick={() => void edits.send(mark)}>
      {t.pattern.notch}
    </button>
  );
}

interface PointFiguresProps {
  piece: Piece;
  part: Part;
  edge: PieceEdge;
  at: Point;
}

function PointFigures({ piece, part, edge, at }: PointFiguresProps) {
  const { edits, pattern } = useCommands();
  if (part.kind === 'edge') return null;
  const move = (to: Point): void =>
    void edits.send(
      part.kind === 'handle'
        ? { edit: 'move_handle', piece: part.piece, edge: part.edge, curve: part.curve, handle: part.handle, to }
        : { edit: 'move_point', piece: part.piece, edge: part.edge, point: part.point, to },
    );
  const words = edgeWords(piece, edge.id);
  const name =
    part.kind === 'handle' ? t.pattern.handleOf(words) : part.point === 0 ? t.pattern.cornerOf(words) : t.pattern.pointOf(words);
  return (
    <>
      <h3>{name}</h3>
      <div class="field-row">
        <NumberField label="x" value={at[0]} length digits={2} take={(x) => move([x, at[1]])} />
        <NumberField label="y" value={at[1]} length digits={2} take={(y) => move([at[0], y])} />
      </div>
      <div class="button-row">
        <button class="plain danger" onClick={() => void pattern.remove()}>
          {part.kind === 'handle' ? t.pattern.makeStraight : t.pattern.deletePoint}
        </button>
        {part.kind === 'point' && <NotchButton piece={piece} edge={edge} at={at} />}
      </div>
    </>
  );
}

function edgeKind(edge: PieceEdge): string {
  if (edge.curves.every(isStraight)) return t.pattern.straight;
  return edge.curves.length === 1 ? t.pattern.curve : t.pattern.curves(edge.curves.length);
}

const kKeep = ['start', 'middle', 'end'] as const;
type Keep = (typeof kKeep)[number];

function EdgeFigures({ piece, edge, pieces, part }: { piece: Piece; edge: PieceEdge; pieces: Pieces; part: Part }) {
  const { pattern } = useCommands();
  const words = edgeWords(piece, edge.id);
  return (
    <>
      <h3 class="edge-head">
        {t.pattern.edge}
        <NameField
          key={`${edge.id} ${words}`}
          label={t.pattern.edgeName}
          name={words}
          take={(to) => void pattern.renameEdge(piece.id, edge.id, to)}
        />
        <span class="head-note">{edgeKind(edge)}</span>
      </h3>
      <LengthFields piece={piece} edge={edge} />
      <EdgeButtons piece={piece} edge={edge} part={part} />
      <DartFields piece={piece.id} edge={edge} />
      <SewnIn piece={piece} edge={edge} pieces={pieces} />
    </>
  );
}

function LengthFields({ piece, edge }: { piece: Piece; edge: PieceEdge }) {
  const { edits } = useCommands();
  const keep = useSignal<Keep>('start');
  const set = (length_mm: number): void =>
    void edits.send({ edit: 'set_edge_length', piece: piece.id, edge: edge.id, length_mm, keep: keep.value });
  return (
    <div class="field-row">
      <NumberField label={t.common.length} value={edge.length_mm} length digits={2} take={set} />
      <label class="select-field">
        <span>{t.pattern.keep}</span>
        <select value={keep.value} onChange={(event) => (keep.value = event.currentTarget.value as Keep)}>
          {kKeep.map((value) => (
            <option key={value} value={value}>
              {t.pattern.keeps[value]}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}

function EdgeButtons({ piece, edge, part }: { piece: Piece; edge: PieceEdge; part: Part }) {
  const { edits, pattern } = useCommands();
  const curved = !edge.curves.every(isStraight);
  const next = nextEdge(piece, edge.id);
  const of = { piece: piece.id, edge: edge.id };
  return (
    <div class="button-row">
      <button class="plain" onClick={() => void pattern.bendOrStraighten(piece.id, edge.id)}>
        {curved ? t.pattern.makeStraight : t.pattern.makeCurve}
      </button>
      <button class="plain" onClick={() => void edits.send({ edit: 'insert_point', ...of, at: 0.5 })}>
        {t.pattern.insertPoint}
      </button>
      <button class="plain" onClick={() => void edits.send({ edit: 'split_edge', ...of, at: 0.5 })}>
        {t.pattern.splitMiddle}
      </button>
      {next && (
        <button class="plain" onClick={() => void pattern.joinWithNext(piece.id, edge.id)}>
          {t.pattern.joinWith(edgeWords(piece, next.id))}
        </button>
      )}
      {part.kind !== 'edge' && (
        <button class="plain" onClick={() => pattern.selectPart({ kind: 'edge', ...of })}>
          {t.pattern.wholeEdge}
        </button>
      )}
    </div>
  );
}

/** The seams that use the edge, each a way to it. */
function SewnIn({ piece, edge, pieces }: { piece: Piece; edge: PieceEdge; pieces: Pieces }) {
  const { pattern } = useCommands();
  const seams = seamsOfEdge(pieces.seams, piece.id, edge.id);
  if (seams.length === 0) return null;
  return (
    <p class="sewn-in">
      {t.pattern.sewnIn}{' '}
      {seams.map((index) => (
        <button class="seam-chip" key={index} onClick={() => pattern.selectSeam(pieces.seams[index]!.id)}>
          <i style={{ background: seamColour(index) }} />
          {seamTitle(pieces, pieces.seams[index]!.id)}
        </button>
      ))}
    </p>
  );
}

function DartFields({ piece, edge }: { piece: string; edge: PieceEdge }) {
  const { pattern } = useCommands();
  const width = useSignal(30);
  const depth = useSignal(100);
  return (
    <details class="dart">
      <summary>{t.pattern.dartMiddle}</summary>
      <div class="field-row">
        <NumberField label={t.pattern.width} length value={width.value} take={(mm) => (width.value = mm)} />
        <NumberField label={t.pattern.depth} length value={depth.value} take={(mm) => (depth.value = mm)} />
        <button class="plain" onClick={() => void pattern.addDart(piece, edge.id, width.value, depth.value)}>
          {t.pattern.addDart}
        </button>
      </div>
    </details>
  );
}

/** A dart within the cloth, upright through the middle of the piece. */
function InnerDartFields({ piece }: { piece: Piece }) {
  const { pattern } = useCommands();
  const width = useSignal(20);
  const length = useSignal(150);
  const [x, y] = insideOf(piece.outline);
  const half = length.value / 2;
  return (
    <details class="dart">
      <summary>{t.pattern.dartWithin}</summary>
      <div class="field-row">
        <NumberField label={t.pattern.width} length value={width.value} take={(mm) => (width.value = mm)} />
        <NumberField label={t.common.length} length value={length.value} take={(mm) => (length.value = mm)} />
        <button
          class="plain"
          onClick={() => void pattern.addInnerDart(piece.id, [x, y - half], [x, y + half], width.value)}
        >
          {t.pattern.addDart}
        </button>
      </div>
    </details>
  );
}
