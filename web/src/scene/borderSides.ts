// The borders of the cloth's pieces: where they are sewn and where they end in a hem; the rules of the stills
// (server/render/border_sides.cpp). Pure.

import { rimEdges, weldGroups } from './surface';
import type { ClothTopology } from '../api/frames';

/** A stretch of a piece's border from one corner to the next, all sewn or all not. */
export interface BorderSide {
  piece: number;
  sewn: boolean;
  /** 0 to kSlots - 1; sides that meet at a corner differ. */
  slot: number;
  vertices: number[];
  /** m of flat cloth from the first vertex. */
  along: number[];
}

export const kSlots = 4;
/** Cosine of the turn at which a border has a corner. */
const kCorner = 0.8;

interface Edge {
  from: number;
  to: number;
  sewn: boolean;
}

type Flat = Pick<ClothTopology, 'vertexCount' | 'triangles' | 'sewn' | 'rest' | 'pieces'>;

export function borderSides(cloth: Flat): BorderSide[] {
  return loopsOf(edgesOf(cloth)).flatMap((loop) => cut(loop, cloth));
}

/** An edge is sewn where another lies on it once both are welded. */
function edgesOf({ triangles, vertexCount, sewn }: Flat): Edge[] {
  const rim = rimEdges(triangles, vertexCount);
  const weld = Uint32Array.from({ length: vertexCount }, (_, v) => v);
  const { start, members } = weldGroups(sewn, vertexCount);
  for (let g = 0; g + 1 < start.length; ++g) for (const v of members.subarray(start[g], start[g + 1])) weld[v] = members[start[g]!]!;
  const joint = (i: number): number => {
    const [a, b] = [weld[rim[i]!]!, weld[rim[i + 1]!]!];
    return Math.min(a, b) * vertexCount + Math.max(a, b);
  };
  const uses = new Map<number, number>();
  for (let i = 0; i < rim.length; i += 2) uses.set(joint(i), (uses.get(joint(i)) ?? 0) + 1);
  const edges: Edge[] = [];
  for (let i = 0; i < rim.length; i += 2)
    edges.push({ from: rim[i]!, to: rim[i + 1]!, sewn: sewn.length > 0 && uses.get(joint(i))! > 1 });
  return edges;
}

function loopsOf(edges: Edge[]): Edge[][] {
  const from = new Map<number, Edge[]>();
  for (const edge of edges) from.set(edge.from, [...(from.get(edge.from) ?? []), edge]);
  const taken = new Set<Edge>();
  const loops: Edge[][] = [];
  for (const first of edges) {
    if (taken.has(first)) continue;
    const loop: Edge[] = [];
    for (let at: Edge | undefined = first; at; at = from.get(at.to)?.find((edge) => !taken.has(edge))) {
      taken.add(at);
      loop.push(at);
    }
    loops.push(loop);
  }
  return loops;
}

function cut(loop: Edge[], { rest, pieces }: Flat): BorderSide[] {
  const stepOf = ({ from, to }: Edge): [number, number] => [rest[2 * to]! - rest[2 * from]!, rest[2 * to + 1]! - rest[2 * from + 1]!];
  const isCorner = (one: Edge, next: Edge): boolean => {
    if (one.to !== next.from || one.sewn !== next.sewn) return true;
    const [[ax, ay], [bx, by]] = [stepOf(one), stepOf(next)];
    return ax * bx + ay * by < kCorner * Math.hypot(ax, ay) * Math.hypot(bx, by);
  };
  const first = loop.findIndex((edge, i) => isCorner(loop[(i + loop.length - 1) % loop.length]!, edge));
  const turned = first > 0 ? [...loop.slice(first), ...loop.slice(0, first)] : loop;
  const piece = pieces.findIndex((one) => turned[0]!.from < one.firstVertex + one.vertexCount);
  const sides: BorderSide[] = [];
  turned.forEach((edge, i) => {
    if (i === 0 || isCorner(turned[i - 1]!, edge))
      sides.push({ piece, sewn: edge.sewn, slot: sides.length % kSlots, vertices: [edge.from], along: [0] });
    const side = sides.at(-1)!;
    side.along.push(side.along.at(-1)! + Math.hypot(...stepOf(edge)));
    side.vertices.push(edge.to);
  });
  // The last side of a loop meets the first.
  const last = sides.at(-1)!;
  if (sides.length > 1 && last.slot === 0) last.slot = 2;
  return sides;
}
