// The pointer on the 2D view: pans the plane, moves pieces, points and handles. While it moves, the piece is shown as it will
// be; once the service has answered, as it is.

import { useSignal, useSignalEffect } from '@preact/signals';
import { useRef } from 'preact/hooks';
import type { PatternCommands } from '../commands/PatternCommands';
import type { Edit, Piece, Point } from '../api/types';
import type { AppState } from '../state/AppState';
import type { Part } from '../state/editing';
import { add, aligned, distance, jointsOf, minus, snapped45, withHandleMoved, withPointMoved } from '../state/outline';
import type { PlacedPiece } from '../state/patternGeometry';
import { panned, type Viewport } from './Viewport';

/** Pixels that a press may wander and still is a click. */
const kFar = 4;
/** Pixels within which a point jumps to the height or column of another. */
const kSnap = 5;

interface Press {
  kind: 'pan' | 'piece' | 'part';
  piece: string;
  part: Part | null;
  /** Where the thing was, mm, in its piece. */
  was: Point;
  /** Where the pointer came down: on the page, px. */
  px: Point;
  far: boolean;
}

/** What is shown moved. */
export type Held =
  | { kind: 'piece'; piece: string; by: Point }
  | { kind: 'part'; piece: string; part: Part; to: Point; guides: Point[] };

export interface Hands {
  held: Held | null;
  /** The piece as it is shown now. */
  shown(piece: Piece): Piece;
  pressPiece(piece: string, event: PointerEvent): void;
  grab(part: Part, at: Point, event: PointerEvent): void;
  nudge(part: Part, at: Point, by: Point): void;
  /** Handlers of the plane. */
  plane: {
    onPointerDown(event: PointerEvent): void;
    onPointerMove(event: PointerEvent): void;
    onPointerUp(event: PointerEvent): void;
    onPointerCancel(): void;
  };
}

export interface HandsOptions {
  state: AppState;
  commands: PatternCommands;
  view(): Viewport;
  move(next: Viewport): void;
  clickPaper(): void;
  clickPiece(piece: string): void;
  placed(): readonly PlacedPiece[];
}

export function useHands(options: HandsOptions): Hands {
  const { state, commands } = options;
  const press = useRef<Press | null>(null);
  const held = useSignal<Held | null>(null);
  const sent = useRef(false);
  const nudging = useRef<ReturnType<typeof setTimeout> | null>(null);

  // What was let go of stays where it was put until the pieces come anew.
  useSignalEffect(() => {
    void state.pieces.value;
    if (sent.current) {
      sent.current = false;
      held.value = null;
    }
  });
  useSignalEffect(() => {
    if (state.editing.problem.value) held.value = null;
  });

  const begin = (event: PointerEvent, next: Omit<Press, 'px' | 'far'>): void => {
    event.preventDefault();
    press.current = { ...next, px: [event.clientX, event.clientY], far: false };
  };

  const send = async (now: Held): Promise<void> => {
    sent.current = true;
    const before = state.project.value?.revision;
    if (now.kind === 'piece') await commands.movePiece(now.piece, now.by);
    else await commands.edit(moveEdit(now.part, now.to));
    if (state.project.value?.revision === before) {
      sent.current = false;
      held.value = null;
    }
  };

  const movedTo = (at: Press, event: PointerEvent): Held | null => {
    const { scale } = options.view();
    const by: Point = [(event.clientX - at.px[0]) / scale, -(event.clientY - at.px[1]) / scale];
    if (at.kind === 'piece') return { kind: 'piece', piece: at.piece, by: event.shiftKey ? alongAxis(by) : by };
    if (!at.part) return null;
    const free = add(at.was, by);
    if (event.shiftKey) return heldPart(at.part, snapped45(at.was, free), []);
    if (event.altKey) return heldPart(at.part, free, []);
    const piece = options.placed().find((one) => one.piece.id === at.piece)?.piece;
    const others = (piece?.edges ?? []).flatMap(jointsOf).filter((point) => distance(point, at.was) > 0.01);
    const snap = aligned(free, others, kSnap / scale);
    return heldPart(at.part, snap.at, snap.guides);
  };

  return {
    held: held.value,
    shown: (piece) => {
      const now = held.value;
      if (now?.kind !== 'part' || now.piece !== piece.id) return piece;
      const { part, to } = now;
      if (part.kind === 'point') return withPointMoved(piece, part.edge, part.point, to);
      return part.kind === 'handle' ? withHandleMoved(piece, part.edge, part.curve, part.handle, to) : piece;
    },
    pressPiece: (piece, event) => {
      if (event.button !== 0 || sent.current) return;
      event.stopPropagation();
      begin(event, { kind: 'piece', piece, part: null, was: [0, 0] });
    },
    grab: (part, at, event) => {
      if (event.type === 'pointerdown' && event.button !== 0) return;
      event.stopPropagation();
      commands.selectPart(part);
      if (event.type === 'pointerdown' && !sent.current)
        begin(event, { kind: 'part', piece: part.piece, part, was: at });
    },
    nudge: (part, at, by) => {
      // Presses that follow each other closely become one edit.
      const now = held.value;
      const from = now?.kind === 'part' && JSON.stringify(now.part) === JSON.stringify(part) ? now.to : at;
      const next = heldPart(part, add(from, by), []);
      commands.selectPart(part);
      held.value = next;
      if (nudging.current) clearTimeout(nudging.current);
      nudging.current = setTimeout(() => void send(next), 350);
    },
    plane: {
      onPointerDown: (event) => {
        if (event.button !== 1 && event.button !== 0) return;
        begin(event, { kind: 'pan', piece: '', part: null, was: [0, 0] });
      },
      onPointerMove: (event) => {
        const at = press.current;
        if (!at) return;
        if (event.buttons === 0) return void (press.current = null);
        const by: Point = minus([event.clientX, event.clientY], at.px);
        if (!at.far && Math.hypot(...by) < kFar) return;
        // Only now: a captured pointer's click goes to the plane and not to what lies under it.
        if (!at.far) (event.currentTarget as Element).setPointerCapture(event.pointerId);
        at.far = true;
        if (at.kind === 'pan') {
          options.move(panned(options.view(), ...by));
          at.px = [event.clientX, event.clientY];
        } else {
          held.value = movedTo(at, event);
        }
      },
      onPointerUp: (event) => {
        const at = press.current;
        press.current = null;
        if (!at) return;
        if (!at.far) {
          if (at.kind === 'pan' && event.button === 0) options.clickPaper();
          if (at.kind === 'piece') options.clickPiece(at.piece);
        } else if (held.value && at.kind !== 'pan') {
          void send(held.value);
        }
      },
      onPointerCancel: () => {
        press.current = null;
        held.value = null;
      },
    },
  };
}

const alongAxis = ([x, y]: Point): Point => (Math.abs(x) > Math.abs(y) ? [x, 0] : [0, y]);
const heldPart = (part: Part, to: Point, guides: Point[]): Held => ({
  kind: 'part',
  piece: part.piece,
  part,
  to,
  guides,
});

const rounded = ([x, y]: Point): Point => [Math.round(x * 100) / 100, Math.round(y * 100) / 100];

/** The edit that a drag of a point or a handle comes to. */
export function moveEdit(part: Part, to: Point): Edit {
  const { piece, edge } = part;
  if (part.kind === 'handle')
    return { edit: 'move_handle', piece, edge, curve: part.curve, handle: part.handle, to: rounded(to) };
  return { edit: 'move_point', piece, edge, point: part.kind === 'point' ? part.point : 0, to: rounded(to) };
}
