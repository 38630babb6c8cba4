// The point of the cloth that a ray hits, as the stream's messages name it.

import { Triangle, Vector3, type Intersection } from 'three';
import type { ClothTopology } from '../api/frames';
import type { ClothPoint } from '../state/hands';

/** Which triangle of the topology has these corners; −1: none. The drawing's order is by material, not the topology's. */
function triangleOf({ triangles }: ClothTopology, a: number, b: number, c: number): number {
  for (let i = 0; i < triangles.length; i += 3) {
    const corners = [triangles[i], triangles[i + 1], triangles[i + 2]];
    if (corners.includes(a) && corners.includes(b) && corners.includes(c)) return i / 3;
  }
  return -1;
}

export function clothPoint(hit: Intersection, topology: ClothTopology, positions: Float32Array): ClothPoint | null {
  if (!hit.face) return null;
  const triangle = triangleOf(topology, hit.face.a, hit.face.b, hit.face.c);
  if (triangle < 0) return null;
  const corner = (k: number): Vector3 => new Vector3().fromArray(positions, 3 * topology.triangles[3 * triangle + k]!);
  const shares = Triangle.getBarycoord(hit.point, corner(0), corner(1), corner(2), new Vector3());
  if (!shares) return null; // of a triangle without area
  // Rounding may have put the hit beside an edge.
  const [a, b, c] = shares.toArray().map((share) => Math.max(0, share)) as [number, number, number];
  const sum = a + b + c;
  return { triangle, shares: [a / sum, b / sum, c / sum], at: hit.point.toArray() };
}

/** Where such a point is now, into `place`. */
export function placeOf(point: ClothPoint, topology: ClothTopology, positions: Float32Array, place: Vector3): Vector3 {
  place.set(0, 0, 0);
  point.shares.forEach((share, k) => {
    const vertex = 3 * topology.triangles[3 * point.triangle + k]!;
    place.x += share * positions[vertex]!;
    place.y += share * positions[vertex + 1]!;
    place.z += share * positions[vertex + 2]!;
  });
  return place;
}
