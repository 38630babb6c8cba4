import { describe, expect, it } from 'vitest';
import type { ClothTopology } from '../src/api/frames';
import { borderSides } from '../src/scene/borderSides';
import { seamLines } from '../src/scene/seamLines';

/** Two squares of 10 cm, sewn along x = 0.1. */
const squares = (sewn: number[]): ClothTopology =>
  ({
    vertexCount: 8,
    triangles: new Uint32Array([0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7]),
    sewn: new Uint32Array(sewn),
    rest: new Float32Array([0, 0, 0.1, 0, 0.1, 0.1, 0, 0.1, 0.1, 0, 0.2, 0, 0.2, 0.1, 0.1, 0.1]),
    pieces: [
      { id: 'left', firstVertex: 0, vertexCount: 4, colour: [1, 1, 1] },
      { id: 'right', firstVertex: 4, vertexCount: 4, colour: [1, 1, 1] },
    ],
  }) as unknown as ClothTopology;

describe('borders of pieces', () => {
  it('are cut at corners, and sewn where two lie on each other', () => {
    const sides = borderSides(squares([1, 4, 2, 7]));
    expect(sides).toHaveLength(8);
    expect(sides.filter((side) => side.sewn).map((side) => side.vertices)).toEqual([
      [1, 2],
      [7, 4],
    ]);
    expect(borderSides(squares([])).some((side) => side.sewn)).toBe(false);
  });

  it('stand in other slots where they meet', () => {
    const slots = borderSides(squares([])).map((side) => side.slot);
    expect(new Set(slots.slice(0, 4)).size).toBe(4);
  });
});

describe('seam lines', () => {
  it('tell how far a vertex lies from each side, and how far along', () => {
    const cloth = squares([1, 4, 2, 7]);
    const { distance, along, kind, hems } = seamLines(cloth);
    const { slot } = borderSides(cloth).find((side) => side.vertices[0] === 1)!;
    expect(distance[4 * 0 + slot]).toBeCloseTo(0.1, 6);
    expect(distance[4 * 1 + slot]).toBe(0);
    expect(along[4 * 2 + slot]).toBeCloseTo(0.1, 6);
    expect(kind[4 * 1 + slot]).toBe(0);
    expect(hems[0]).toBeCloseTo(0.15 * 0.05, 6);
  });
});
