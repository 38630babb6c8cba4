// Sides of a body part's box, as a hand meets them. Pure. The box's own axes: x to the wearer's left, y along the part,
// z to the front.

import type { BoxSide } from '../api/dressing';

/** The side with this outward normal, in the box's own axes; null for the two ends. */
export function faceOf([x, y, z]: [number, number, number]): BoxSide | null {
  if (Math.abs(y) > Math.max(Math.abs(x), Math.abs(z))) return null;
  if (Math.abs(z) >= Math.abs(x)) return z > 0 ? 'front' : 'back';
  return x > 0 ? 'left' : 'right';
}

/** A point of the side, m in the box's own axes from its middle, as the side's own place: mm to the right as one looks at it, and up along the part. */
export function onFace(side: BoxSide, [x, y, z]: [number, number, number]): [number, number] {
  const right = { front: x, back: -x, left: -z, right: z }[side];
  return [Math.round(right * 1000), Math.round(y * 1000)];
}
