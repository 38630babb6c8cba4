// What part of the plane the 2D view shows. Pure; world millimetres with y down, as SVG has it.

import type { Room } from '../state/packing';
import type { Box } from '../state/patternGeometry';

export interface Viewport {
  /** World point at the middle of the view. */
  x: number;
  y: number;
  /** Pixels a millimetre. */
  scale: number;
}

/** By hand; what is fitted may be smaller. */
const kSmallest = 0.02;
const kLargest = 20;

/** Pixels of the view's rim that nothing is fitted into. */
export interface Rim {
  side: number;
  top: number;
  bottom: number;
}

/** What the rim leaves of a view. */
export const roomWithin = ({ width, height }: Room, { side, top, bottom }: Rim): Room => ({
  width: Math.max(width - 2 * side, 20),
  height: Math.max(height - top - bottom, 20),
});

/** Shows a whole box (y up) within the rim. */
export function fit(box: Box, view: Room, rim: Rim): Viewport {
  const w = Math.max(box.maxX - box.minX, 1);
  const h = Math.max(box.maxY - box.minY, 1);
  const room = roomWithin(view, rim);
  const { top, bottom } = rim;
  const scale = Math.min(kLargest, room.width / w, room.height / h);
  return { x: (box.minX + box.maxX) / 2, y: -(box.minY + box.maxY) / 2 - (top - bottom) / 2 / scale, scale };
}

/** What is seen within the rim, y up. */
export function seenBox({ x, y, scale }: Viewport, { width, height }: Room, { side, top, bottom }: Rim): Box {
  const [half, high] = [width / 2 - side, height / 2];
  return { minX: x - half / scale, maxX: x + half / scale, minY: -y - (high - bottom) / scale, maxY: -y + (high - top) / scale };
}

export const panned = (view: Viewport, dxPx: number, dyPx: number): Viewport => ({
  ...view,
  x: view.x - dxPx / view.scale,
  y: view.y - dyPx / view.scale,
});

/** Zooms about a point given in pixels from the view's middle, which stays where it is. What is larger than any garment is seen whole all the same. */
export function zoomed(view: Viewport, factor: number, px = 0, py = 0): Viewport {
  const scale = Math.min(kLargest, Math.max(Math.min(kSmallest, view.scale), view.scale * factor));
  const keep = 1 / view.scale - 1 / scale;
  return { x: view.x + px * keep, y: view.y + py * keep, scale };
}

export const viewBox = (view: Viewport, width: number, height: number): string =>
  [view.x - width / view.scale / 2, view.y - height / view.scale / 2, width / view.scale, height / view.scale].join(
    ' ',
  );
