// Hands on the cloth of a drape under way: which tool is taken, and what this page's hand holds.

import { signal, type Signal } from '@preact/signals';
import type { Place } from '../api/dressing';

export type HandTool = 'look' | 'pull' | 'pin';

/** A point of the cloth, as the stream's messages name it, and where it was when it was touched, m. */
export interface ClothPoint {
  triangle: number;
  shares: [number, number, number];
  at: Place;
}

/** What a hand holds, and to where it draws it, m. */
export interface Held {
  point: ClothPoint;
  to: Place;
}

export class HandsState {
  readonly tool: Signal<HandTool> = signal('look');
  readonly held: Signal<Held | null> = signal(null);
  /** The pin that is pointed at in the list, by its number. */
  readonly litPin: Signal<number | null> = signal(null);
}
