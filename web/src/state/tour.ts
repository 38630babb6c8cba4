// The tour for somebody who has just come: five places of the page, each pointed at with a card beside it. Pure.

import type { Texts } from '../texts/en';

export interface TourStop {
  id: keyof Texts['tour']['stops'];
  /** Where it is on the page, as the style sheet finds it: the first that is shown. */
  places: readonly string[];
}

/** In the order in which a garment comes to be worn. */
export const tourStops: readonly TourStop[] = [
  { id: 'cloth', places: ['.scene'] },
  { id: 'pattern', places: ['.pattern', '.tabs'] },
  { id: 'body', places: ['.tabs'] },
  { id: 'drape', places: ['.topbar .actions'] },
  { id: 'result', places: ['.tab-panel'] },
];

export interface Rect {
  left: number;
  top: number;
  width: number;
  height: number;
}

interface Size {
  width: number;
  height: number;
}

/** Between the card and what it points at, and the window's border, px. */
const kGap = 14;
/** What is lower is a bar, px. */
const kBar = 60;

/** Where a card stands: beside the place if there is room, else below or above, else within it; of a bar the other way round. Always in the window. */
export function besides(place: Rect, card: Size, window: Size): { left: number; top: number } {
  const across = (left: number): number => clamp(left, window.width - card.width);
  const down = (top: number): number => clamp(top, window.height - card.height);
  const { left, top, width, height } = place;
  const right = left + width;
  const bottom = top + height;
  const beside = [
    { fits: right + kGap + card.width + kGap <= window.width, at: { left: right + kGap, top: down(top) } },
    { fits: left - kGap - card.width >= kGap, at: { left: left - kGap - card.width, top: down(top) } },
  ];
  const upright = [
    { fits: bottom + kGap + card.height + kGap <= window.height, at: { left: across(right - card.width), top: bottom + kGap } },
    { fits: top - kGap - card.height >= kGap, at: { left: across(left), top: top - kGap - card.height } },
  ];
  const all = height < kBar ? [...upright, ...beside] : [...beside, ...upright];
  return all.find(({ fits }) => fits)?.at ?? { left: across(left + kGap), top: down(bottom - card.height - kGap) };
}

const clamp = (value: number, most: number): number => Math.max(kGap, Math.min(value, most - kGap));
