import { describe, expect, it } from 'vitest';
import type { Curve, Point } from '../src/api/types';
import {
  aligned,
  bentHandles,
  curveAt,
  isStraight,
  jointsOf,
  lengthOfCurves,
  nearestOn,
  nextEdge,
  notchAt,
  pathOf,
  piecePath,
  snapped45,
  straight,
  withHandleMoved,
  withPointMoved,
} from '../src/state/outline';
import { squareOf } from './fakes';

const arch: Curve = [
  [0, 0],
  [0, 40],
  [100, 40],
  [100, 0],
];

describe('curves', () => {
  it('are straight when their handles lie at the thirds', () => {
    expect(isStraight(straight([3, 4], [90, -20]))).toBe(true);
    expect(isStraight(arch)).toBe(false);
    expect(curveAt(arch, 0.5)).toEqual([50, 30]);
  });

  it('have their length along the bend', () => {
    expect(lengthOfCurves([straight([0, 0], [30, 40])])).toBeCloseTo(50, 9);
    // By 10,000 chords: 122.75 mm.
    let exact = 0;
    for (let i = 0; i < 10000; ++i) {
      const [a, b] = [curveAt(arch, i / 10000), curveAt(arch, (i + 1) / 10000)];
      exact += Math.hypot(a[0] - b[0], a[1] - b[1]);
    }
    expect(Math.abs(lengthOfCurves([arch]) / exact - 1)).toBeLessThan(1e-3);
  });

  it('become SVG paths with y down', () => {
    expect(pathOf([straight([0, 0], [10, 5])], false)).toBe('M0 0L10 -5');
    expect(pathOf([arch], true)).toBe('M0 0C0 -40 100 -40 100 0Z');
    expect(piecePath({ ...squareOf('a', 0, 0, 10), edges: [] })).toBe('M0 0L10 0L10 -10L0 -10Z');
  });

  it('are bent to the outside of the piece', () => {
    const [h1, h2] = bentHandles(straight([0, 0], [100, 0]));
    expect(h1[1]).toBeLessThan(0);
    expect(h2[1]).toBe(h1[1]);
  });
});

describe('the nearest place of an edge', () => {
  it('is told by its fraction of the length', () => {
    const found = nearestOn(squareOf('a', 0, 0, 100).edges[1]!, [120, 25]);
    expect(found.point).toEqual([100, 25]);
    expect(found.at).toBeCloseTo(0.25, 9);
    expect(found.distance).toBeCloseTo(20, 9);
  });
});

describe('a dragged point', () => {
  const square = squareOf('a', 0, 0, 100);

  it('takes both edges of a corner along, which stay straight', () => {
    const moved = withPointMoved(square, 'e1', 1, [130, 120]);
    expect(moved.outline).toContainEqual([130, 120]);
    expect(moved.edges[1]!.curves[0]![3]).toEqual([130, 120]);
    expect(moved.edges[2]!.curves[0]![0]).toEqual([130, 120]);
    expect(moved.edges.every((edge) => edge.curves.every(isStraight))).toBe(true);
    expect(moved.edges[0]).toBe(square.edges[0]);
    expect(moved.edges[1]!.length_mm).toBeCloseTo(Math.hypot(30, 120), 3);
  });

  it('takes the handles of curves beside it along', () => {
    const bent = withHandleMoved(square, 'e2', 0, 1, [90, 140]);
    const moved = withPointMoved(bent, 'e1', 1, [110, 100]);
    expect(moved.edges[2]!.curves[0]![1]).toEqual([100, 140]);
    expect(moved.edges[2]!.curves[0]![2]).toEqual(bent.edges[2]!.curves[0]![2]);
  });

  it('leaves the piece as it is where there is no such point', () => {
    expect(withPointMoved(square, 'e9', 0, [1, 1])).toBe(square);
    expect(withPointMoved(square, 'e1', 7, [1, 1])).toBe(square);
  });

  it('keeps to steps of 45° with Shift', () => {
    const near = (from: Point, to: Point): Point => snapped45(from, to).map((v) => Math.round(v * 1e6) / 1e6) as Point;
    expect(near([10, 10], [60, 14])).toEqual([60, 10]);
    expect(near([0, 0], [30, 34])).toEqual([32, 32]);
  });

  it('jumps to the height or column of another within reach', () => {
    const others: Point[] = [
      [0, 0],
      [100, 50],
    ];
    expect(aligned([98, 20], others, 5)).toEqual({ at: [100, 20], guides: [[100, 50]] });
    expect(aligned([50, 20], others, 5)).toEqual({ at: [50, 20], guides: [] });
  });
});

describe('edges', () => {
  it('follow each other around their loop', () => {
    const square = squareOf('a', 0, 0, 10);
    expect(nextEdge(square, 'e3')?.id).toBe('e0');
    expect(nextEdge({ ...square, edges: [square.edges[0]!] }, 'e0')).toBeNull();
    expect(jointsOf(square.edges[0]!)).toEqual([
      [0, 0],
      [10, 0],
    ]);
  });
});

describe('notches', () => {
  it('are found at the point of the outline that they mark', () => {
    const piece = { ...squareOf('front', 0, 0, 100), notches: [{ at: [100, 50] as Point, depth_mm: 5, inwards: null }] };
    expect(notchAt(piece, [100, 50.05])).toBe(0);
    expect(notchAt(piece, [100, 60])).toBe(-1);
  });
});
