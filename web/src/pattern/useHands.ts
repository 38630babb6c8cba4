// The pointer on the 2D view: it pans the plane, or does what the tool that is held makes of it.

import { useRef, type MutableRef } from 'preact/hooks';
import type { Point } from '../api/types';
import { samePart, type Part } from '../state/editing';
import { minus } from '../state/outline';
import type { Drag, EdgePlace, Hand, Held, PatternTool, Spot, Way } from '../tools/PatternTool';
import { useHeld, type HeldState } from './useHeld';
import { panned, type Viewport } from './Viewport';

/** Pixels that a press may wander and still is a click. */
const kFar = 4;
/** Pixels within which a point jumps to the height or column of another. */
const kSnap = 5;
/** Pixels within which a place on an outline jumps along it. */
const kTraceSnap = 7;
/** Arrow keys that follow each other within this many milliseconds become one edit. */
const kNudgeMs = 350;

interface Press {
  /** Null: the plane itself moves. */
  drag: Drag | null;
  click: (event: PointerEvent) => void;
  /** Where the pointer came down: on the page, px. */
  px: Point;
  far: boolean;
}

export interface Hands {
  held: Held | null;
  pressPiece(piece: string, event: PointerEvent): void;
  clickPiece(piece: string): void;
  pressEdge(at: EdgePlace, event: PointerEvent | KeyboardEvent): void;
  grab(part: Part, at: Point, event: PointerEvent | KeyboardEvent): void;
  nudge(part: Part, at: Point, by: Point): void;
  /** Handlers of the plane. */
  plane: PlaneHandlers;
}

export interface PlaneHandlers {
  onPointerDown(event: PointerEvent): void;
  onPointerMove(event: PointerEvent): void;
  onPointerUp(event: PointerEvent): void;
  onPointerCancel(): void;
  onPointerLeave(): void;
}

export interface HandsOptions {
  hand: Hand;
  tool: PatternTool;
  view(): Viewport;
  move(next: Viewport): void;
  /** The point of the plane under the pointer, mm. */
  worldOf(event: MouseEvent): Point;
}

const isPointer = (event: PointerEvent | KeyboardEvent): event is PointerEvent => event.type === 'pointerdown';

/** Another button than the first is for the view. */
const isOther = (event: PointerEvent | KeyboardEvent): boolean => isPointer(event) && event.button !== 0;

export function useHands(options: HandsOptions): Hands {
  const { hand, tool } = options;
  const press = useRef<Press | null>(null);
  const tracedBy = useRef<number | null>(null);
  const held = useHeld();
  const nudge = useNudge(options, held);

  const begin = (event: PointerEvent, drag: Drag | null, click: Press['click']): void => {
    event.preventDefault();
    press.current = { drag, click, px: [event.clientX, event.clientY], far: false };
  };

  return {
    held: held.now(),
    pressPiece: (piece, event) => {
      if (!tool.dragPiece || event.button !== 0 || held.isOnItsWay()) return;
      event.stopPropagation();
      begin(event, tool.dragPiece(hand, piece), () => tool.clickPiece(hand, piece));
    },
    clickPiece: (piece) => tool.clickPiece(hand, piece),
    pressEdge: (at, event) => {
      if (isOther(event) || (tool.trace && isPointer(event))) return;
      event.stopPropagation();
      tool.edges?.press(hand, at, isPointer(event) ? null : event.key);
    },
    grab: (part, at, event) => {
      if (isOther(event)) return;
      event.stopPropagation();
      const drag = tool.grab?.(hand, part, at);
      if (drag && isPointer(event) && !held.isOnItsWay()) begin(event, drag, () => undefined);
    },
    nudge,
    plane: tracing(options, tracedBy, planeHandlers(options, held, press, begin)),
  };
}

/** Moves a part by keys. */
function useNudge({ hand, tool }: HandsOptions, held: HeldState): Hands['nudge'] {
  const waiting = useRef<ReturnType<typeof setTimeout> | null>(null);
  return (part, at, by) => {
    // Presses that follow each other closely become one edit: they go on from what is shown.
    const shown = held.now();
    const from = shown && samePart(shown.part, part) ? (shown.at ?? at) : at;
    const drag = tool.grab?.(hand, part, from);
    if (!drag) return;
    const next = drag.to(by, { shift: false, alt: true, reach: 0 });
    held.show(next);
    if (waiting.current) clearTimeout(waiting.current);
    waiting.current = setTimeout(() => void held.send(drag, next), kNudgeMs);
  };
}

/** The plane's handlers, behind those of a tool that follows the pointer; `by` is the one that is pressed. */
function tracing({ hand, tool, view, worldOf }: HandsOptions, by: MutableRef<number | null>, plane: PlaneHandlers): PlaneHandlers {
  const { trace } = tool;
  if (!trace) return plane;
  const spotOf = (event: PointerEvent): Spot => ({ at: worldOf(event), way: wayOf(event, view().scale, kTraceSnap) });
  return {
    onPointerDown: (event) => {
      if (event.button !== 0 || !trace.press(hand, spotOf(event))) return plane.onPointerDown(event);
      event.preventDefault();
      by.current = event.pointerId;
      const sheet = event.currentTarget as SVGSVGElement;
      // A button that was pressed before would take the keys that follow.
      sheet.focus({ preventScroll: true });
      sheet.setPointerCapture(event.pointerId);
    },
    onPointerMove: (event) => {
      if (event.buttons === 0 || by.current !== null) trace.move(hand, spotOf(event));
      if (by.current === null) plane.onPointerMove(event);
    },
    onPointerUp: (event) => {
      if (by.current !== event.pointerId) return plane.onPointerUp(event);
      by.current = null;
      trace.release(hand, spotOf(event));
    },
    onPointerCancel: () => {
      by.current = null;
      plane.onPointerCancel();
    },
    onPointerLeave: () => {
      trace.move(hand, null);
      plane.onPointerLeave();
    },
  };
}

type Begin = (event: PointerEvent, drag: Drag | null, click: Press['click']) => void;

function planeHandlers(
  { hand, view, move }: HandsOptions,
  held: HeldState,
  press: MutableRef<Press | null>,
  begin: Begin,
): PlaneHandlers {
  const clickPaper = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    hand.commands.pattern.selectPart(null);
    hand.commands.select(null);
  };
  const follow = (now: Press, by: Point, event: PointerEvent): void => {
    const { scale } = view();
    if (now.drag) return held.show(now.drag.to([by[0] / scale, -by[1] / scale], wayOf(event, scale)));
    move(panned(view(), ...by));
    now.px = [event.clientX, event.clientY];
  };
  return {
    onPointerDown: (event) => {
      if (event.button === 0 || event.button === 1) begin(event, null, clickPaper);
    },
    onPointerMove: (event) => {
      const now = press.current;
      if (!now) return;
      if (event.buttons === 0) return void (press.current = null);
      const by: Point = minus([event.clientX, event.clientY], now.px);
      if (!now.far && Math.hypot(...by) < kFar) return;
      // Only now: a captured pointer's click goes to the plane and not to what lies under it.
      if (!now.far) (event.currentTarget as Element).setPointerCapture(event.pointerId);
      now.far = true;
      follow(now, by, event);
    },
    onPointerUp: (event) => {
      const now = press.current;
      press.current = null;
      if (!now) return;
      const shown = held.now();
      if (!now.far) now.click(event);
      else if (now.drag && shown) void held.send(now.drag, shown);
    },
    onPointerCancel: () => {
      press.current = null;
      held.show(null);
    },
    onPointerLeave: () => undefined,
  };
}

const wayOf = ({ shiftKey, altKey }: PointerEvent, scale: number, snap = kSnap): Way => ({
  shift: shiftKey,
  alt: altKey,
  reach: snap / scale,
});
