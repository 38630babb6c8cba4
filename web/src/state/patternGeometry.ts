// Flat pieces in figures: boxes, places inside, lengths of lines. Pure; millimetres, y up.

import type { Point } from '../api/types';

export interface Box {
  minX: number;
  minY: number;
  maxX: number;
  maxY: number;
}

export function boxOf(points: readonly Point[]): Box {
  const box = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
  for (const [x, y] of points) {
    box.minX = Math.min(box.minX, x);
    box.minY = Math.min(box.minY, y);
    box.maxX = Math.max(box.maxX, x);
    box.maxY = Math.max(box.maxY, y);
  }
  return box;
}

export function joined(boxes: readonly Box[]): Box {
  return boxOf(
    boxes.flatMap((box): Point[] => [
      [box.minX, box.minY],
      [box.maxX, box.maxY],
    ]),
  );
}

export const movedBox = (box: Box, [dx, dy]: Point): Box => ({
  minX: box.minX + dx,
  minY: box.minY + dy,
  maxX: box.maxX + dx,
  maxY: box.maxY + dy,
});

export const widthOf = (box: Box): number => box.maxX - box.minX;
export const heightOf = (box: Box): number => box.maxY - box.minY;

/** A point inside an outline that is a good place for a label: the middle of the widest span of some level lines. */
export function insideOf(outline: readonly Point[]): Point {
  const box = boxOf(outline);
  let best: Point = [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2];
  let widest = 0;
  for (const level of [0.5, 0.42, 0.58, 0.3, 0.7]) {
    const y = box.minY + level * heightOf(box);
    const cuts = cutsAt(outline, y);
    for (let i = 0; i + 1 < cuts.length; i += 2) {
      const span = cuts[i + 1]! - cuts[i]!;
      if (span > widest * 1.25) {
        widest = span;
        best = [(cuts[i]! + cuts[i + 1]!) / 2, y];
      }
    }
  }
  return best;
}

/** How wide an outline is on the level of a point within it. */
export function spanAt(outline: readonly Point[], [x, y]: Point): number {
  const cuts = cutsAt(outline, y);
  const after = cuts.findIndex((cut) => cut > x);
  return after > 0 ? cuts[after]! - cuts[after - 1]! : 0;
}

function cutsAt(outline: readonly Point[], y: number): number[] {
  const cuts: number[] = [];
  outline.forEach(([x0, y0], i) => {
    const [x1, y1] = outline[(i + 1) % outline.length]!;
    if (y0 <= y !== y1 <= y) cuts.push(x0 + ((y - y0) / (y1 - y0)) * (x1 - x0));
  });
  return cuts.sort((a, b) => a - b);
}

export function lengthOf(points: readonly Point[]): number {
  let sum = 0;
  for (let i = 1; i < points.length; ++i)
    sum += Math.hypot(points[i]![0] - points[i - 1]![0], points[i]![1] - points[i - 1]![1]);
  return sum;
}

/** The part of a polyline between two fractions of its length. */
export function cutLine(points: readonly Point[], from: number, to: number): Point[] {
  if ((from <= 0 && to >= 1) || points.length < 2) return [...points];
  const whole = lengthOf(points);
  const out: Point[] = [];
  let gone = 0;
  for (let i = 1; i < points.length; ++i) {
    const [a, b] = [points[i - 1]!, points[i]!];
    const step = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const at = (length: number): Point => {
      const t = step > 0 ? (length - gone) / step : 0;
      return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    };
    const first = Math.max(gone, from * whole);
    const last = Math.min(gone + step, to * whole);
    if (last > first) {
      if (out.length === 0) out.push(at(first));
      out.push(at(last));
    }
    gone += step;
  }
  return out;
}

/** Linear RGB as a CSS colour. */
export function cssColour(linear: readonly number[]): string {
  const channel = (c: number): number =>
    Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * Math.max(c, 0) ** (1 / 2.4) - 0.055));
  return `rgb(${linear
    .slice(0, 3)
    .map((c) => Math.min(255, channel(c)))
    .join(' ')})`;
}
