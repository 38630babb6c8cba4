// What a tool of the 2D view is: one object that says how it is called and what it makes of the pointer. The views ask the
// tool that is held and know none by its name, so that a tool is added by a file of its own and a line in table.ts.

import type { ComponentChildren, ComponentType } from 'preact';
import type { Piece, Pieces, Point } from '../api/types';
import type { Commands } from '../commands/Commands';
import type { AppState } from '../state/AppState';
import type { Part, ToolFacts } from '../state/editing';

/** What a hand works on, and with. */
export interface Hand {
  readonly state: AppState;
  readonly commands: Commands;
}

export interface EdgePlace {
  piece: string;
  edge: string;
}

/** What is shown while something is held, and from there until the service has answered. */
export interface Held {
  readonly piece: string;
  /** The part that is held; null for the whole piece. */
  readonly part: Part | null;
  /** How far the whole piece has come, mm. */
  readonly by: Point;
  /** Where the part is now, mm in its piece. */
  readonly at: Point | null;
  /** Points of the piece that the part is in line with. */
  readonly guides: readonly Point[];
  /** The piece as it will be. */
  shown(piece: Piece): Piece;
}

/** How the pointer is moved. */
export interface Way {
  /** In steps of 45°. */
  readonly shift: boolean;
  /** Without jumping to what is near. */
  readonly alt: boolean;
  /** How near that is, mm. */
  readonly reach: number;
}

/** Where the pointer is on the plane. */
export interface Spot {
  /** mm, y up. */
  readonly at: Point;
  readonly way: Way;
}

/** Follows the pointer over all of the plane, pressed or not, before anything that lies on it is asked. */
export interface Trace {
  /** Null: it has left. */
  move(hand: Hand, spot: Spot | null): void;
  /** False: the press is for what lies below. */
  press(hand: Hand, spot: Spot): boolean;
  release(hand: Hand, spot: Spot): void;
}

/** What a press becomes when the pointer moves. It keeps nothing: what it returned last is handed back to it. */
export interface Drag {
  /** What is held once the pointer is `by` mm from where it came down. */
  to(by: Point, way: Way): Held;
  /** Resolves when the service has answered. */
  drop(held: Held): Promise<void>;
}

/** What a tool does with edges; one without them leaves edges to what lies below. */
export interface EdgeHandlers {
  /** Whose edges the Tab key comes to; the pointer reaches those of all pieces. */
  readonly tabbed: 'selected' | 'all';
  /** `key` is what pressed it; null: the pointer. */
  press(hand: Hand, at: EdgePlace, key: string | null): void;
  /** A double click at a place of the piece, mm. */
  double?(hand: Hand, at: EdgePlace, place: Point): void;
}

export interface ToolWords {
  /** On its button. */
  readonly title: string;
  /** What it does: on its button, and in the list of keys. */
  readonly hint: string;
  readonly help: string;
}

export interface PatternTool extends ToolFacts {
  /** What it is called, in the language that is spoken. */
  words(): ToolWords;
  /** The letter that takes it. */
  readonly key: string;

  /** CSS cursors that differ from the usual ones. */
  readonly cursor?: { readonly paper?: string; readonly piece?: string; readonly selected?: string };

  /** A click on a piece, or Enter. */
  clickPiece(hand: Hand, piece: string): void;
  /** A press on a piece; without it the piece is paper, which moves the view. */
  dragPiece?(hand: Hand, piece: string): Drag;
  clickSeam?(hand: Hand, seam: string): void;
  readonly edges?: EdgeHandlers;
  readonly trace?: Trace;
  /** Takes a point or handle of the selected piece, which stands at `at`; without it none are shown. */
  grab?(hand: Hand, part: Part, at: Point): Drag;

  /** What to do next, while nothing else is to be said. */
  say?(state: AppState): ComponentChildren;
  /** Beside the pattern, over what is selected. */
  readonly Panel?: ComponentType<{ pieces: Pieces }>;
}
