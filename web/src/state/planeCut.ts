// Where a level plane meets a mesh: outlines in the plane, seen from above. Pure.

import type { BodyMesh } from '../api/body';
import type { ClothTopology } from '../api/frames';

/** x and z, m. */
export type Place2 = readonly [number, number];

/** An outline in the plane; a closed one does not say its first place again at the end. */
export interface Outline {
  places: Place2[];
  closed: boolean;
  /** m, of the outline; and of the same way on the flat pieces, where the mesh is cloth. */
  length: number;
  flat: number;
}

export interface CutMesh {
  /** xyz of each node, m. */
  positions: Float32Array;
  /** Three nodes a triangle. */
  triangles: Uint32Array;
  /** Of cloth: xy of each vertex on its flat piece, m, and the vertices of the same triangles before they were joined. */
  flat?: { rest: Float32Array; triangles: Uint32Array };
}

/** Sewn pairs further apart than this are no way through, m; as the service's table of the fit has it. */
const kOpen = 0.01;

/** The cloth with its shut seams joined: both sides of a stitch are one node, in their middle. */
export function joinedCloth({ triangles, rest, sewn, vertexCount }: ClothTopology, positions: Float32Array): CutMesh {
  const root = new Uint32Array(vertexCount).map((_, v) => v);
  const rootOf = (v: number): number => {
    let at = v;
    while (root[at] !== at) at = root[at]!;
    return at;
  };
  for (let i = 0; i < sewn.length; i += 2) {
    const [a, b] = [sewn[i]!, sewn[i + 1]!];
    if (distance(positions, a, b) > kOpen) continue;
    const [p, q] = [rootOf(a), rootOf(b)];
    root[Math.max(p, q)] = Math.min(p, q);
  }
  const sums = new Float64Array(positions.length);
  const counts = new Uint16Array(vertexCount);
  for (let v = 0; v < vertexCount; ++v) {
    const to = rootOf(v);
    root[v] = to;
    counts[to]! += 1;
    for (let axis = 0; axis < 3; ++axis) sums[3 * to + axis]! += positions[3 * v + axis]!;
  }
  const middles = Float32Array.from(sums, (sum, i) => sum / Math.max(1, counts[Math.floor(i / 3)]!));
  return { positions: middles, triangles: triangles.map((v) => root[v]!), flat: { rest, triangles } };
}

/** A body whose vertices that lie in one place are one node: files tell corners of their surface several times. */
export function joinedBody({ positions, indices }: BodyMesh): CutMesh {
  const first = new Map<string, number>();
  const nodes = new Uint32Array(positions.length / 3);
  for (let v = 0; v < nodes.length; ++v) {
    const place = `${positions[3 * v]} ${positions[3 * v + 1]} ${positions[3 * v + 2]}`;
    const known = first.get(place);
    if (known === undefined) first.set(place, v);
    nodes[v] = known ?? v;
  }
  return { positions, triangles: indices.map((v) => nodes[v]!) };
}

function distance(p: Float32Array, a: number, b: number): number {
  return Math.hypot(p[3 * a]! - p[3 * b]!, p[3 * a + 1]! - p[3 * b + 1]!, p[3 * a + 2]! - p[3 * b + 2]!);
}

/** What a triangle leaves in the plane, between two places where its edges meet it. */
interface Stretch {
  ends: readonly [number, number];
  flat: number;
  walked: boolean;
}

/** The outlines of the mesh at a height, m. A vertex in the plane counts as above it, so that each edge meets it once. */
export function cutAt(mesh: CutMesh, height: number): Outline[] {
  const cut = new Cut(mesh, height);
  return cut.outlines();
}

class Cut {
  private readonly places_: Place2[] = [];
  /** Where an edge meets the plane, by its two nodes. */
  private readonly byEdge_ = new Map<number, number>();
  private readonly at_: Stretch[][] = [];

  constructor(
    private readonly mesh_: CutMesh,
    private readonly height_: number,
  ) {
    for (let t = 0; t < mesh_.triangles.length; t += 3) this.cutTriangle(t);
  }

  outlines(): Outline[] {
    const found: Outline[] = [];
    // Open ends first: what is left then are ways that come back to where they began.
    const starts = this.at_.map((_, i) => i).sort((a, b) => Number(this.isEnd(b)) - Number(this.isEnd(a)));
    for (const start of starts) {
      while (this.at_[start]!.some(({ walked }) => !walked)) found.push(...this.walk(start));
    }
    return found;
  }

  private isEnd(place: number): boolean {
    return this.at_[place]!.length % 2 === 1;
  }

  private isAbove(node: number): boolean {
    return this.mesh_.positions[3 * node + 1]! >= this.height_;
  }

  private cutTriangle(t: number): void {
    const corners = [0, 1, 2].map((k) => this.mesh_.triangles[t + k]!);
    const above = corners.map((node) => this.isAbove(node));
    const lone = above.findIndex((is, k) => is !== above[(k + 1) % 3] && is !== above[(k + 2) % 3]);
    if (lone < 0) return;
    const ends = [1, 2].map((k) => this.placeOn(corners[lone]!, corners[(lone + k) % 3]!)) as [number, number];
    if (ends[0] === ends[1]) return;
    const stretch = { ends, flat: this.flatLength(t, lone), walked: false };
    for (const end of ends) this.at_[end]!.push(stretch);
  }

  /** How far along the edge from a to b the plane is met. */
  private share(a: number, b: number): number {
    const [from, to] = [this.mesh_.positions[3 * a + 1]!, this.mesh_.positions[3 * b + 1]!];
    return (this.height_ - from) / (to - from);
  }

  private placeOn(a: number, b: number): number {
    const { positions } = this.mesh_;
    const [low, high] = [Math.min(a, b), Math.max(a, b)];
    const edge = low * (positions.length / 3) + high;
    const known = this.byEdge_.get(edge);
    if (known !== undefined) return known;
    const share = this.share(low, high);
    const along = (axis: number): number =>
      positions[3 * low + axis]! + share * (positions[3 * high + axis]! - positions[3 * low + axis]!);
    this.byEdge_.set(edge, this.places_.length);
    this.places_.push([along(0), along(2)]);
    this.at_.push([]);
    return this.places_.length - 1;
  }

  private flatLength(t: number, lone: number): number {
    const { flat, triangles } = this.mesh_;
    if (!flat) return 0;
    const on = (k: number): Place2 => {
      const share = this.share(triangles[t + lone]!, triangles[t + k]!);
      const [a, b] = [flat.triangles[t + lone]!, flat.triangles[t + k]!];
      const along = (axis: number): number =>
        flat.rest[2 * a + axis]! + share * (flat.rest[2 * b + axis]! - flat.rest[2 * a + axis]!);
      return [along(0), along(1)];
    };
    return apart(on((lone + 1) % 3), on((lone + 2) % 3));
  }

  /** As far as it goes from there. Where it comes back to a place of its own, what lies between is a closed outline. */
  private walk(start: number): Outline[] {
    const closed: Outline[] = [];
    let way: { place: number; flat: number }[] = [{ place: start, flat: 0 }];
    for (;;) {
      const here = way[way.length - 1]!.place;
      const next = this.straightest(way[way.length - 2]?.place, here);
      if (!next) break;
      next.walked = true;
      const place = next.ends[0] === here ? next.ends[1] : next.ends[0];
      const before = way.findIndex((one) => one.place === place);
      if (before < 0) {
        way.push({ place, flat: next.flat });
        continue;
      }
      const flat = way.slice(before + 1).reduce((sum, one) => sum + one.flat, next.flat);
      closed.push(this.outline(way.slice(before), true, flat));
      way = way.slice(0, before + 1);
    }
    if (way.length === 1) return closed;
    return [...closed, this.outline(way, false, way.reduce((sum, one) => sum + one.flat, 0))];
  }

  /** Where three pieces meet at a seam there are several ways on. */
  private straightest(from: number | undefined, here: number): Stretch | undefined {
    const ways = this.at_[here]!.filter(({ walked }) => !walked);
    if (from === undefined || ways.length < 2) return ways[0];
    const turn = ({ ends }: Stretch): number => {
      const to = this.places_[ends[0] === here ? ends[1] : ends[0]]!;
      const [a, b] = [this.places_[from]!, this.places_[here]!];
      const [p, q] = [heading(a, b), heading(b, to)];
      return -(p[0] * q[0] + p[1] * q[1]);
    };
    return ways.reduce((best, one) => (turn(one) < turn(best) ? one : best));
  }

  private outline(way: { place: number }[], closed: boolean, flat: number): Outline {
    const places = way.map(({ place }) => this.places_[place]!);
    return { places, closed, flat, length: lengthOf(places, closed) };
  }
}

function heading(a: Place2, b: Place2): Place2 {
  const far = apart(a, b) || 1;
  return [(b[0] - a[0]) / far, (b[1] - a[1]) / far];
}

export const apart = (a: Place2, b: Place2): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

export function lengthOf(places: readonly Place2[], closed: boolean): number {
  const open = places.reduce((sum, place, i) => (i === 0 ? 0 : sum + apart(places[i - 1]!, place)), 0);
  return closed && places.length > 1 ? open + apart(places[places.length - 1]!, places[0]!) : open;
}
