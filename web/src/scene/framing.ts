// Where the camera stands for a view. Pure. The body faces +z; "side" shows its left, as the stills do.

import type { View } from '../state/AppState';

export type Vec3 = [number, number, number];

export interface Bounds {
  low: Vec3;
  high: Vec3;
}

export interface Pose {
  eye: Vec3;
  target: Vec3;
}

/** Upright field of view, degrees. */
export const kFov = 32;
/** A body alone is framed whole; cloth with this much more room around it, m. */
export const kBodyOnly: Bounds = { low: [-0.5, 0, -0.3], high: [0.5, 1.75, 0.3] };

const kDirections: Record<View, Vec3> = {
  front: [0, 0.08, 1],
  back: [0, 0.08, -1],
  side: [1, 0.08, 0],
  'three-quarter': [0.62, 0.24, 1],
};

export function boundsOf(positions: Float32Array): Bounds | null {
  if (positions.length < 3) return null;
  const low: Vec3 = [Infinity, Infinity, Infinity];
  const high: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    const k = i % 3;
    low[k] = Math.min(low[k]!, positions[i]!);
    high[k] = Math.max(high[k]!, positions[i]!);
  }
  return { low, high };
}

function union(a: Bounds | null, b: Bounds | null): Bounds | null {
  if (!a || !b) return a ?? b;
  return {
    low: a.low.map((x, k) => Math.min(x, b.low[k]!)) as Vec3,
    high: a.high.map((x, k) => Math.max(x, b.high[k]!)) as Vec3,
  };
}

/** Free space around what is shown, as a share of the picture. */
const kMargin = 0.16;

/** Looks at the whole of `bounds`. `fov` is the upright field of view in degrees, `aspect` width over height. */
export function poseFor(view: View, bounds: Bounds, fov: number, aspect: number): Pose {
  const target = bounds.low.map((x, k) => (x + bounds.high[k]!) / 2) as Vec3;
  const size = bounds.high.map((x, k) => Math.max(x - bounds.low[k]!, 0.05)) as Vec3;
  const direction = normalized(kDirections[view]);
  const across = Math.abs(direction[2]) * size[0] + Math.abs(direction[0]) * size[2];
  const deep = Math.abs(direction[0]) * size[0] + Math.abs(direction[2]) * size[2];
  const slope = Math.tan((fov * Math.PI) / 360) * (1 - kMargin);
  const away = Math.max(size[1] / 2 / slope, across / 2 / (slope * aspect)) + deep / 2;
  return { eye: target.map((x, k) => x + away * direction[k]!) as Vec3, target };
}

/** What a view shows: the cloth, with the body's width around the start so that nothing jumps; else the body. Before the
 *  drape (`starting`) all of both is shown: the pieces stand around the body. */
export function poseOf(view: View, cloth: Bounds | null, body: Bounds | null, starting: boolean, aspect: number): Pose {
  if (starting) return poseFor(view, union(cloth, body) ?? kBodyOnly, kFov, aspect);
  const bounds = cloth ?? body ?? kBodyOnly;
  const tall = body && cloth && cloth.high[1] - cloth.low[1] > 0.6 * (body.high[1] - body.low[1]);
  return poseFor(view, tall ? union(bounds, body)! : bounds, kFov, aspect);
}

/** Metres from the eye to what is looked at closely. */
const kClose = 1.25;

/** Close to a place, seen from outside of what stands around `around`'s middle; of a place on the middle's upright from where
 *  the eye is now. */
export function closeUp(place: Vec3, around: Bounds, now: Pose): Pose {
  const middle = around.low.map((x, k) => (x + around.high[k]!) / 2) as Vec3;
  const out: Vec3 = [place[0] - middle[0], 0, place[2] - middle[2]];
  const seen: Vec3 = [now.eye[0] - now.target[0], 0, now.eye[2] - now.target[2]];
  const flat = Math.hypot(...out) > 0.03 ? out : Math.hypot(...seen) > 1e-6 ? seen : ([0, 0, 1] as Vec3);
  const level = normalized(flat);
  const direction = normalized([level[0], 0.22, level[2]]);
  return { eye: place.map((x, k) => x + kClose * direction[k]!) as Vec3, target: place };
}

function normalized(v: Vec3): Vec3 {
  const length = Math.hypot(...v);
  return v.map((x) => x / length) as Vec3;
}

/** Ease in and out, 0 to 1. */
export const eased = (t: number): number => (t < 0.5 ? 4 * t * t * t : 1 - (2 - 2 * t) ** 3 / 2);

/** Where something stands on the ground: middle and half widths, m. */
export interface Footprint {
  x: number;
  z: number;
  across: number;
  along: number;
}

/** As high above its lowest point a body still counts as standing on the ground, m. */
const kSole = 0.03;

/** Under the left and the right half of a body that stands on the ground. */
export function footprints(positions: Float32Array): Footprint[] {
  const boxes = [true, false].map((left) => soleOf(positions, left));
  return boxes.flatMap((box) => (box ? [box] : []));
}

function soleOf(positions: Float32Array, left: boolean): Footprint | null {
  let [x0, x1, z0, z1] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let v = 0; v < positions.length; v += 3) {
    const [x, y, z] = [positions[v]!, positions[v + 1]!, positions[v + 2]!];
    if (Math.abs(y) > kSole || x > 0 !== left) continue;
    [x0, x1, z0, z1] = [Math.min(x0, x), Math.max(x1, x), Math.min(z0, z), Math.max(z1, z)];
  }
  if (x1 < x0) return null;
  return { x: (x0 + x1) / 2, z: (z0 + z1) / 2, across: (x1 - x0) / 2, along: (z1 - z0) / 2 };
}
