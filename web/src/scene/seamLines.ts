// How far each vertex lies from the borders of its piece: what seams and hems are drawn by, as in the stills
// (server/render/seam_lines.cpp, panel_make.cpp). Pure.

import type { ClothTopology } from '../api/frames';
import { borderSides, kSlots, type BorderSide } from './borderSides';

/** By slot of the sides: of all sides of the piece in a slot, the nearest one. */
export interface SeamLines {
  /** m of flat cloth; 1 where no side is near. */
  distance: Float32Array;
  /** m from the side's beginning. */
  along: Float32Array;
  /** 0: a seam, 2: a hem. */
  kind: Float32Array;
  /** For each piece, m from a free edge to the stitches that hold it. */
  hems: number[];
}

/** m; lines are drawn within 3 cm of a border. */
const kReach = 0.05;
/** Longest edges of a border: on coarse cloth a triangle reaches farther. */
const kEdges = 2.5;
const kHem = 0.018;
/** Of a piece's breadth, at most. */
const kHemShare = 0.15;

export function seamLines(cloth: ClothTopology): SeamLines {
  const sides = borderSides(cloth);
  const numbers = (): Float32Array => new Float32Array(kSlots * cloth.vertexCount);
  const lines: SeamLines = { distance: numbers().fill(1), along: numbers(), kind: numbers(), hems: hemsOf(cloth, sides) };
  const longest = Math.max(0, ...sides.map(({ along }) => Math.max(...along.slice(1).map((to, i) => to - along[i]!))));
  const reach = Math.max(kReach, kEdges * longest);
  for (const side of sides) measure(side, cloth, reach, lines);
  return lines;
}

function measure(side: BorderSide, { rest, pieces }: ClothTopology, reach: number, lines: SeamLines): void {
  const xs = side.vertices.map((v) => rest[2 * v]!);
  const ys = side.vertices.map((v) => rest[2 * v + 1]!);
  const [left, right] = [Math.min(...xs) - reach, Math.max(...xs) + reach];
  const [low, high] = [Math.min(...ys) - reach, Math.max(...ys) + reach];
  const { firstVertex, vertexCount } = pieces[side.piece]!;
  for (let v = firstVertex; v < firstVertex + vertexCount; ++v) {
    const [x, y] = [rest[2 * v]!, rest[2 * v + 1]!];
    if (x < left || x > right || y < low || y > high) continue;
    const at = kSlots * v + side.slot;
    for (let i = 0; i + 1 < xs.length; ++i) {
      const [dx, dy] = [xs[i + 1]! - xs[i]!, ys[i + 1]! - ys[i]!];
      const square = dx * dx + dy * dy;
      const share = square > 0 ? Math.min(1, Math.max(0, ((x - xs[i]!) * dx + (y - ys[i]!) * dy) / square)) : 0;
      const away = Math.hypot(x - xs[i]! - share * dx, y - ys[i]! - share * dy);
      if (away >= lines.distance[at]!) continue;
      lines.distance[at] = away;
      lines.along[at] = side.along[i]! + share * (side.along[i + 1]! - side.along[i]!);
      lines.kind[at] = side.sewn ? 0 : 2;
    }
  }
}

/** 18 mm, and less on narrow pieces, whose breadth is twice their area over their border. */
function hemsOf({ pieces, triangles, rest }: ClothTopology, sides: readonly BorderSide[]): number[] {
  const areas = pieces.map(() => 0);
  const borders = pieces.map(() => 0);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [2 * triangles[t]!, 2 * triangles[t + 1]!, 2 * triangles[t + 2]!];
    const twice =
      (rest[b]! - rest[a]!) * (rest[c + 1]! - rest[a + 1]!) - (rest[b + 1]! - rest[a + 1]!) * (rest[c]! - rest[a]!);
    const piece = pieces.findIndex((one) => triangles[t]! < one.firstVertex + one.vertexCount);
    if (piece >= 0) areas[piece]! += Math.abs(twice) / 2;
  }
  for (const side of sides) borders[side.piece]! += side.along.at(-1)!;
  return pieces.map((_, p) => Math.min(kHem, borders[p]! > 0 ? (kHemShare * 2 * areas[p]!) / borders[p]! : 0));
}
