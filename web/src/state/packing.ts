// Boxes laid out so that they are seen as large as may be in a room of a given shape. Pure; y up.

import type { Point } from '../api/types';
import { heightOf, joined, movedBox, widthOf, type Box } from './patternGeometry';

/** Pixels, or anything of the same shape. */
export interface Room {
  width: number;
  height: number;
}

/** How large boxes are seen in a room that shows all of them: its pixels for each of their millimetres. */
export function scaleIn(boxes: readonly Box[], room: Room): number {
  const all = joined(boxes);
  return Math.min(room.width / Math.max(all.maxX - all.minX, 1e-9), room.height / Math.max(all.maxY - all.minY, 1e-9));
}

/** Widths that are tried, from that of the widest box to that of all in one row. */
const kTries = 24;

/**
 * Where to move boxes so that none lies on another, `gap` between them, and the room shows them largest: as far up,
 * then left, as there is room (the bottom-left rule of Baker, Coffman and Rivest 1980), tallest first, for several widths.
 */
export function packed(boxes: readonly Box[], room: Room, gap: number): Point[] {
  const least = Math.max(...boxes.map(widthOf));
  const most = boxes.reduce((sum, box) => sum + widthOf(box) + gap, 0);
  let best: Point[] = [];
  let largest = 0;
  for (let i = 0; i < kTries; ++i) {
    const offsets = packedWithin(boxes, least * (most / least) ** (i / (kTries - 1)), gap);
    const scale = scaleIn(boxes.map((box, k) => movedBox(box, offsets[k]!)), room);
    if (scale <= largest * (1 + 1e-9)) continue;
    largest = scale;
    best = offsets;
  }
  return best;
}

/** A level part of the skyline: how far down it has been filled from x on. */
interface Step {
  x: number;
  width: number;
  down: number;
}

function packedWithin(boxes: readonly Box[], width: number, gap: number): Point[] {
  const order = boxes.map((_, i) => i).sort((a, b) => heightOf(boxes[b]!) - heightOf(boxes[a]!) || a - b);
  const offsets: Point[] = boxes.map(() => [0, 0]);
  let skyline: Step[] = [{ x: 0, width: width + gap, down: 0 }];
  for (const i of order) {
    const box = boxes[i]!;
    const [w, h] = [widthOf(box) + gap, heightOf(box) + gap];
    const { x, down } = highestPlace(skyline, w);
    offsets[i] = [x - box.minX, -down - box.maxY];
    skyline = filled(skyline, { x, width: w, down: down + h });
  }
  return offsets;
}

/** The place for a width that is filled least far down, the leftmost of those. */
function highestPlace(skyline: readonly Step[], width: number): { x: number; down: number } {
  const end = skyline[skyline.length - 1]!;
  const room = end.x + end.width;
  let best = { x: 0, down: Infinity };
  for (const { x } of skyline) {
    if (x + width > room + 1e-6) break;
    const down = Math.max(...skyline.filter((step) => step.x < x + width - 1e-6 && step.x + step.width > x + 1e-6).map((step) => step.down));
    if (down < best.down) best = { x, down };
  }
  return best;
}

/** The skyline with a box under it: what the box lies below is cut away. */
function filled(skyline: readonly Step[], box: Step): Step[] {
  const end = box.x + box.width;
  const rest = skyline.flatMap((step): Step[] => {
    const before = { ...step, width: Math.min(step.width, box.x - step.x) };
    const from = Math.max(step.x, end);
    const after = { ...step, x: from, width: step.x + step.width - from };
    return [before, after].filter((part) => part.width > 1e-6);
  });
  return [...rest, box].sort((a, b) => a.x - b.x);
}
