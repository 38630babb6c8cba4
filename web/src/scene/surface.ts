// Geometry of the cloth for drawing: which vertices seams join, smooth normals over them, edges worth a line. Pure.

import type { ClothTopology } from '../api/frames';
import type { Point } from '../api/types';
import type { SeamPart } from '../state/seamView';

/** Vertices that sewing makes one, as groups of two and more. */
export interface WeldGroups {
  /** Where each group begins in `members`, and one past the last. */
  start: Uint32Array;
  members: Uint32Array;
}

export function weldGroups(sewn: Uint32Array, vertexCount: number): WeldGroups {
  const parent = Uint32Array.from({ length: vertexCount }, (_, v) => v);
  const root = (v: number): number => {
    while (parent[v] !== v) {
      parent[v] = parent[parent[v]!]!; // halves the way for whoever asks next
      v = parent[v]!;
    }
    return v;
  };
  for (let i = 0; i < sewn.length; i += 2) {
    const a = root(sewn[i]!);
    const b = root(sewn[i + 1]!);
    parent[Math.max(a, b)] = Math.min(a, b);
  }
  const groups = new Map<number, number[]>();
  for (const v of new Set(sewn)) {
    const r = root(v);
    const group = groups.get(r);
    if (group) group.push(v);
    else groups.set(r, [v]);
  }
  const start = [0];
  const members: number[] = [];
  for (const group of groups.values()) {
    members.push(...group);
    start.push(members.length);
  }
  return { start: new Uint32Array(start), members: new Uint32Array(members) };
}

/** Normals of a triangle mesh, each face by its area; `out` has three numbers a vertex. */
export function vertexNormals(positions: Float32Array, triangles: Uint32Array, out: Float32Array): void {
  out.fill(0);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t]!;
    const b = 3 * triangles[t + 1]!;
    const c = 3 * triangles[t + 2]!;
    const ux = positions[b]! - positions[a]!;
    const uy = positions[b + 1]! - positions[a + 1]!;
    const uz = positions[b + 2]! - positions[a + 2]!;
    const vx = positions[c]! - positions[a]!;
    const vy = positions[c + 1]! - positions[a + 1]!;
    const vz = positions[c + 2]! - positions[a + 2]!;
    const nx = uy * vz - uz * vy;
    const ny = uz * vx - ux * vz;
    const nz = ux * vy - uy * vx;
    for (const v of [a, b, c]) {
      out[v]! += nx;
      out[v + 1]! += ny;
      out[v + 2]! += nz;
    }
  }
}

/** Sewn vertices share their normal once they lie together; before, each side keeps its own. Then all get length 1. */
export function shareNormals(positions: Float32Array, welds: WeldGroups, out: Float32Array, closed = 0.002): void {
  for (let g = 0; g + 1 < welds.start.length; ++g) {
    const first = welds.start[g]!;
    const end = welds.start[g + 1]!;
    const a = 3 * welds.members[first]!;
    let x = 0;
    let y = 0;
    let z = 0;
    let apart = false;
    for (let i = first; i < end; ++i) {
      const v = 3 * welds.members[i]!;
      x += out[v]!;
      y += out[v + 1]!;
      z += out[v + 2]!;
      apart ||= distance(positions, a, v) > closed;
    }
    if (apart) continue;
    for (let i = first; i < end; ++i) out.set([x, y, z], 3 * welds.members[i]!);
  }
  for (let v = 0; v < out.length; v += 3) {
    const length = Math.hypot(out[v]!, out[v + 1]!, out[v + 2]!) || 1;
    out[v]! /= length;
    out[v + 1]! /= length;
    out[v + 2]! /= length;
  }
}

const distance = (p: Float32Array, a: number, b: number): number =>
  Math.hypot(p[a]! - p[b]!, p[a + 1]! - p[b + 1]!, p[a + 2]! - p[b + 2]!);

/** Edges of one triangle only, as vertex pairs in the triangle's direction. */
export function rimEdges(triangles: Uint32Array, vertexCount: number): Uint32Array {
  const once = new Map<number, [number, number]>();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; ++k) {
      const a = triangles[t + k]!;
      const b = triangles[t + ((k + 1) % 3)]!;
      const key = Math.min(a, b) * vertexCount + Math.max(a, b);
      if (once.has(key)) once.delete(key);
      else once.set(key, [a, b]);
    }
  }
  return new Uint32Array([...once.values()].flat());
}

/** Those of the rim's edges whose ends are both sewn: where a seam shows as a line. */
export function seamEdges(rim: Uint32Array, sewn: Uint32Array): Uint32Array {
  const joined = new Set(sewn);
  const edges: number[] = [];
  for (let i = 0; i < rim.length; i += 2) {
    if (joined.has(rim[i]!) && joined.has(rim[i + 1]!)) edges.push(rim[i]!, rim[i + 1]!);
  }
  return new Uint32Array(edges);
}

/** Widest distance between the two ends of a sewn pair, m. */
export function widestGap(positions: Float32Array, sewn: Uint32Array): number {
  let widest = 0;
  for (let i = 0; i < sewn.length; i += 2)
    widest = Math.max(widest, distance(positions, 3 * sewn[i]!, 3 * sewn[i + 1]!));
  return widest;
}

/** A run of triangles that are drawn with the same material; in numbers of the index. */
export interface MaterialGroup {
  start: number;
  count: number;
  material: number;
}

/** The triangles put together by the material of their first vertex; groups of none are left out. */
export function byMaterial(
  triangles: Uint32Array,
  materialOf: Uint16Array,
  count: number,
): { index: Uint32Array; groups: MaterialGroup[] } {
  const index = new Uint32Array(triangles.length);
  const groups: MaterialGroup[] = [];
  let at = 0;
  for (let material = 0; material < count; ++material) {
    const start = at;
    for (let t = 0; t < triangles.length; t += 3) {
      if (materialOf[triangles[t]!] !== material) continue;
      index.set(triangles.subarray(t, t + 3), at);
      at += 3;
    }
    if (at > start) groups.push({ start, count: at - start, material });
  }
  return { index, groups };
}

/** How far a vertex of an outline may lie off the line that it was sampled from, mm. */
const kOnLine = 1.5;

/** Vertices of the cloth's rim (pairs, as rimEdges has them) that lie on a seam's sides, told by their flat places. */
export function verticesAlong(parts: readonly SeamPart[], { pieces, rest }: ClothTopology, rim: Uint32Array): number[] {
  const found = new Set<number>();
  for (const part of parts) {
    const piece = pieces.find((one) => one.id === part.piece);
    if (!piece) continue;
    const end = piece.firstVertex + piece.vertexCount;
    for (const v of rim) {
      if (v < piece.firstVertex || v >= end || found.has(v)) continue;
      if (isOnLine([1000 * rest[2 * v]!, 1000 * rest[2 * v + 1]!], part.points)) found.add(v);
    }
  }
  return [...found];
}

function isOnLine([x, y]: Point, line: readonly Point[]): boolean {
  return line.some(([ax, ay], i) => {
    const [bx, by] = line[i + 1] ?? [ax, ay];
    const [dx, dy] = [bx - ax, by - ay];
    const square = dx * dx + dy * dy;
    const t = square > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
    return Math.hypot(x - ax - t * dx, y - ay - t * dy) < kOnLine;
  });
}

/** Every edge of the mesh once. */
export function allEdges(triangles: Uint32Array, vertexCount: number): Uint32Array {
  const edges = new Map<number, [number, number]>();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; ++k) {
      const a = triangles[t + k]!;
      const b = triangles[t + ((k + 1) % 3)]!;
      edges.set(Math.min(a, b) * vertexCount + Math.max(a, b), [a, b]);
    }
  }
  return new Uint32Array([...edges.values()].flat());
}
