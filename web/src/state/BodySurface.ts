// The body's surface, sorted into cells, so that the way to it is found without a look at all of its triangles. Metres.

import type { BodyMesh } from '../api/body';

/** Side of a cell, m: about as wide as the body's triangles. */
const kCell = 0.05;

export class BodySurface {
  /** Triangles by the cells that their boxes touch. */
  private readonly cells_ = new Map<number, number[]>();
  private readonly seen_: Uint32Array;
  private look_ = 0;

  constructor(private readonly body_: BodyMesh) {
    const count = body_.indices.length / 3;
    this.seen_ = new Uint32Array(count);
    for (let t = 0; t < count; ++t) this.sortIn(t);
  }

  /** From a place to the nearest triangle, `most` at most. */
  distance(x: number, y: number, z: number, most: number): number {
    this.look_ += 1;
    const [i, j, k] = [cellOf(x), cellOf(y), cellOf(z)];
    let nearest = most * most;
    // Cells in shells around the place: what lies in later ones is further away than the shell before is wide.
    for (let shell = 0; (shell - 1) * kCell < Math.sqrt(nearest) && shell * kCell <= most + kCell; ++shell) {
      for (let a = i - shell; a <= i + shell; ++a) {
        for (let b = j - shell; b <= j + shell; ++b) {
          const rim = Math.max(Math.abs(a - i), Math.abs(b - j)) === shell;
          for (let c = k - shell; c <= k + shell; c += rim || shell === 0 ? 1 : 2 * shell)
            nearest = this.nearestIn(keyOf(a, b, c), x, y, z, nearest);
        }
      }
    }
    return Math.sqrt(nearest);
  }

  private nearestIn(key: number, x: number, y: number, z: number, nearest: number): number {
    for (const t of this.cells_.get(key) ?? []) {
      if (this.seen_[t] === this.look_) continue;
      this.seen_[t] = this.look_;
      nearest = Math.min(nearest, this.square(t, x, y, z));
    }
    return nearest;
  }

  private sortIn(t: number): void {
    const { positions, indices } = this.body_;
    const range = (axis: number): [number, number] => {
      const at = [0, 1, 2].map((corner) => positions[3 * indices[3 * t + corner]! + axis]!);
      return [cellOf(Math.min(...at)), cellOf(Math.max(...at))];
    };
    const [[x0, x1], [y0, y1], [z0, z1]] = [range(0), range(1), range(2)];
    for (let i = x0; i <= x1; ++i) {
      for (let j = y0; j <= y1; ++j) {
        for (let k = z0; k <= z1; ++k) {
          const key = keyOf(i, j, k);
          const cell = this.cells_.get(key);
          if (cell) cell.push(t);
          else this.cells_.set(key, [t]);
        }
      }
    }
  }

  /** Square of the distance to a triangle (Ericson 2005, Real-Time Collision Detection, 5.1.5). */
  private square(t: number, x: number, y: number, z: number): number {
    const { positions: p, indices } = this.body_;
    const [a, b, c] = [3 * indices[3 * t]!, 3 * indices[3 * t + 1]!, 3 * indices[3 * t + 2]!];
    const ab = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!] as const;
    const ac = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!] as const;
    const ap = [x - p[a]!, y - p[a + 1]!, z - p[a + 2]!] as const;
    const [s, w] = nearestOf(dot(ab, ab), dot(ab, ac), dot(ac, ac), dot(ab, ap), dot(ac, ap));
    const off = ap.map((d, axis) => d - s * ab[axis]! - w * ac[axis]!) as unknown as Vec;
    return dot(off, off);
  }
}

type Vec = readonly [number, number, number];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cellOf = (metres: number): number => Math.floor(metres / kCell);
/** Bodies are some metres large: a thousand cells to each side are enough for none to be taken for another. */
const keyOf = (i: number, j: number, k: number): number => ((i + 1024) * 2048 + (j + 1024)) * 2048 + (k + 1024);
const clamp = (value: number): number => Math.min(1, Math.max(0, value));

/** Shares of both sides at a triangle's nearest point; `bb`, `bc`, `cc` of the sides, `bp`, `cp` of sides and place. */
function nearestOf(bb: number, bc: number, cc: number, bp: number, cp: number): [number, number] {
  const whole = bb * cc - bc * bc;
  const s = (cc * bp - bc * cp) / whole;
  const w = (bb * cp - bc * bp) / whole;
  if (s >= 0 && w >= 0 && s + w <= 1) return [s, w];
  const onB = clamp(bp / bb);
  const onC = clamp(cp / cc);
  const slant = clamp((cp - bp + bb - bc) / (bb - 2 * bc + cc));
  const square = ([u, v]: [number, number]): number => u * u * bb + 2 * u * v * bc + v * v * cc - 2 * (u * bp + v * cp);
  const sides: [number, number][] = [
    [onB, 0],
    [0, onC],
    [1 - slant, slant],
  ];
  return sides.reduce((best, one) => (square(one) < square(best) ? one : best));
}
