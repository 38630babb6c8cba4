import { describe, expect, it } from 'vitest';
import { layOut, type PlacedPiece } from '../src/state/layout';
import { packed, scaleIn } from '../src/state/packing';
import { movedBox, type Box } from '../src/state/patternGeometry';
import { pieceOf, squareOf } from './fakes';

const wide = { width: 300, height: 100 };

const isApart = (a: Box, b: Box): boolean => a.maxX <= b.minX || b.maxX <= a.minX || a.maxY <= b.minY || b.maxY <= a.minY;
const expectApart = (placed: readonly Pick<PlacedPiece, 'box'>[]): void =>
  placed.forEach((a, i) => placed.slice(i + 1).forEach((b) => expect(isApart(a.box, b.box)).toBe(true)));

describe('pieces in the flat view', () => {
  it('stay where the pattern has them', () => {
    expect(layOut([squareOf('a', 0, 0, 100), squareOf('b', 300, 40, 50)], wide).map((piece) => piece.offset)).toEqual([
      [0, 0],
      [0, 0],
    ]);
  });

  it('are laid apart where they would cover each other', () => {
    const placed = layOut(['a', 'b', 'c', 'd'].map((id, i) => squareOf(id, 0, 0, 100 + 10 * i)), wide);
    expectApart(placed);
  });

  it('are laid anew where the pattern has them in one long row, and another shape shows them larger', () => {
    const placed = layOut(['a', 'b', 'c', 'd', 'e', 'f'].map((id, i) => squareOf(id, 150 * i, 0, 100)), { width: 100, height: 100 });
    const width =
      Math.max(...placed.map((piece) => piece.box.maxX)) - Math.min(...placed.map((piece) => piece.box.minX));
    expect(width).toBeLessThan(600);
  });

  it('of a large pattern fill the room, whatever its shape', () => {
    // Two halves of a circle skirt, four of a bodice, a waistband of two: all drafted over each other.
    const sizes = [[1280, 720], [1280, 570], [240, 380], [240, 380], [260, 420], [260, 420], [390, 47], [450, 47]] as const;
    const pieces = sizes.map(([w, h], i) => pieceOf(`p${i}`, [[0, 0], [w, 0], [w, h], [0, h]]));
    const area = sizes.reduce((sum, [w, h]) => sum + w * h, 0);
    for (const room of [wide, { width: 100, height: 100 }, { width: 370, height: 160 }, { width: 390, height: 500 }]) {
      const placed = layOut(pieces, room);
      expectApart(placed);
      const filled = area * scaleIn(placed.map(({ box }) => box), room) ** 2;
      expect(filled / (room.width * room.height)).toBeGreaterThan(0.45);
    }
  });

  it('stay where they were shown when one is moved, and new ones come beside them', () => {
    const kept = new Map<string, [number, number]>([
      ['a', [0, 0]],
      ['b', [120, 0]],
    ]);
    const placed = layOut([squareOf('a', 0, 0, 100), squareOf('b', 0, 0, 100), squareOf('c', 50, 50, 100)], wide, kept);
    expect(placed.slice(0, 2).map((piece) => piece.offset)).toEqual([
      [0, 0],
      [120, 0],
    ]);
    expect(placed[2]!.box.minX).toBeGreaterThan(220);
  });
});

describe('packing', () => {
  it('keeps a gap, and takes one row where the room is one', () => {
    const boxes = [0, 1, 2].map((): Box => ({ minX: 10, minY: 20, maxX: 20, maxY: 30 }));
    const places = packed(boxes, { width: 90, height: 10 }, 5).map((offset, i) => movedBox(boxes[i]!, offset));
    expect(places.map(({ minX, maxY }) => [minX, maxY])).toEqual([[0, 0], [15, 0], [30, 0]]);
  });
});
