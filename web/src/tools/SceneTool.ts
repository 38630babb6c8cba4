// What a tool of the 3D view is. What can be done there follows from what is open beside it, so several are held at once,
// and a press goes to the first of them that takes it. No tool knows how things are drawn: it asks a touch.

import type { Place, PieceWish } from '../api/dressing';
import type { AppState } from '../state/AppState';
import type { ClothPoint } from '../state/hands';
import type { Hand } from './PatternTool';

/** Where on a box something comes to lie. */
export type BoxPlace = Pick<PieceWish, 'part' | 'side' | 'at_mm'>;

/** What lies under the pointer, nearest first, and what can be shown there. */
export interface SceneTouch {
  piece(): string | null;
  /** Of the map on the cloth; NaN where there is none. */
  mapValue(): number;
  /** A point of the cloth, where it is nearer than the body. */
  cloth(): ClothPoint | null;
  /** The place under the pointer that is as deep in the picture as `at`, m. */
  beside(at: Place): Place;
  landmark(): string | null;
  /** A place of the body, under cloth or not. */
  skin(): Place | null;
  /** The place on a side of a box, which is lit up; null where there is none. */
  box(): BoxPlace | null;
  /** The boxes are seen, whatever is switched on, until this ends. */
  openBoxes(open: boolean): void;
  /** Shows a landmark elsewhere. */
  moveLandmark(name: string, to: Place): void;
}

/** What letting go now would do. */
export interface Aim {
  /** CSS cursor; without one it stays as it is. */
  readonly cursor?: string;
  drop(): void;
}

/** A press that goes on. */
export interface SceneDrag {
  /** CSS cursor from the press on. */
  readonly cursor?: string;
  /** Whether letting go where it began is a click on what lies there. */
  readonly clicks: boolean;
  /** The pointer has gone far enough to be no click. */
  begin?(touch: SceneTouch): void;
  /** Null: as before. */
  to(touch: SceneTouch): Aim | null;
  /** After the drop, and when it comes to nothing. */
  end?(touch: SceneTouch): void;
}

export interface SceneTool {
  readonly id: string;
  /** Reads signals, so that the view follows. */
  isHeld(state: AppState): boolean;
  /** CSS cursor over the view while it is held. */
  readonly cursor?: string;
  /** Null: not for this tool, and the view may turn. */
  press?(hand: Hand, touch: SceneTouch): SceneDrag | null;
  /** Whether it was for this tool. */
  click?(hand: Hand, touch: SceneTouch): boolean;
  /** The pointer passes over without a button; null: it leaves. */
  hover?(hand: Hand, touch: SceneTouch | null): void;
}
