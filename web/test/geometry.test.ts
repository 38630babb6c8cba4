import { describe, expect, it } from 'vitest';
import { decodeBody } from '../src/api/body';
import { clothFromObj } from '../src/api/objCloth';
import type { Piece, Point } from '../src/api/types';
import { fit, panned, zoomed } from '../src/pattern/Viewport';
import { boundsOf, poseFor } from '../src/scene/framing';
import { rimEdges, seamEdges, shareNormals, vertexNormals, weldGroups, widestGap } from '../src/scene/surface';
import { cssColour, insideOf, layOut, seamHue, seamLines } from '../src/state/patternGeometry';

/** Two squares that meet at x = 1 at a right angle; vertices 1, 2 are sewn to 4, 7. */
const positions = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, -1, 1, 1, -1, 1, 1, 0]);
const triangles = new Uint32Array([0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7]);
const sewn = new Uint32Array([1, 4, 2, 7]);

describe('the cloth’s surface', () => {
  it('has one normal over a closed seam and its own on either side of an open one', () => {
    const normals = new Float32Array(24);
    vertexNormals(positions, triangles, normals);
    shareNormals(positions, weldGroups(sewn, 8), normals);
    expect([...normals.slice(3, 6)]).toEqual([...normals.slice(12, 15)]);
    expect(Math.min(normals[3]!, normals[5]!)).toBeGreaterThan(0.4);
    const open = positions.slice();
    open[12] = open[21] = 1.5;
    vertexNormals(open, triangles, normals);
    shareNormals(open, weldGroups(sewn, 8), normals);
    expect([...normals.slice(3, 6)]).toEqual([0, 0, 1]);
    expect(widestGap(open, sewn)).toBeCloseTo(0.5, 6);
  });

  it('joins chains of pairs into one group', () => {
    const { start, members } = weldGroups(new Uint32Array([5, 2, 2, 9, 0, 1]), 10);
    const groups = Array.from({ length: start.length - 1 }, (_, g) =>
      [...members.slice(start[g], start[g + 1])].sort(),
    );
    expect(groups).toContainEqual([2, 5, 9]);
    expect(groups).toContainEqual([0, 1]);
  });

  it('shows seams where sewn rims are, and no inner edge', () => {
    const rim = rimEdges(triangles, 8);
    expect(rim.length / 2).toBe(8);
    const seams = seamEdges(rim, sewn);
    expect(seams.length / 2).toBe(2);
  });
});

describe('the camera', () => {
  it('looks from in front with the whole garment in the picture', () => {
    const { eye, target } = poseFor('front', boundsOf(positions)!, 32, 1.5);
    expect(target).toEqual([0.5, 0.5, -0.5]);
    expect(eye[2]).toBeGreaterThan(target[2] + 1);
    expect(eye[0]).toBeCloseTo(0.5, 6);
    expect(poseFor('side', boundsOf(positions)!, 32, 1.5).eye[0]).toBeGreaterThan(1.5);
  });
});

const square = (id: string, x: number, y: number, size: number): Piece => {
  const outline: Point[] = [
    [x, y],
    [x + size, y],
    [x + size, y + size],
    [x, y + size],
  ];
  return {
    id,
    outline,
    holes: [],
    grain: [0, 1],
    fabric: 'f',
    colour: [1, 1, 1],
    edges: [{ id: 'e0', points: outline.slice(0, 2) }],
  };
};

describe('flat pieces', () => {
  it('stay where the pattern has them', () => {
    expect(layOut([square('a', 0, 0, 100), square('b', 300, 40, 50)]).map((piece) => piece.offset)).toEqual([
      [0, 0],
      [0, 0],
    ]);
  });

  it('are laid apart where they would cover each other', () => {
    const placed = layOut(['a', 'b', 'c', 'd'].map((id, i) => square(id, 0, 0, 100 + 10 * i)));
    placed.forEach((a, i) =>
      placed.forEach((b, j) => {
        if (i < j)
          expect(
            a.box.maxX <= b.box.minX ||
              b.box.maxX <= a.box.minX ||
              a.box.maxY <= b.box.minY ||
              b.box.maxY <= a.box.minY,
          ).toBe(true);
      }),
    );
  });

  it('have their name inside, also when they are bent', () => {
    const [x, y] = insideOf([
      [0, 0],
      [100, 0],
      [100, 100],
      [80, 100],
      [80, 20],
      [0, 20],
    ]);
    expect((x > 80 && y < 100) || y < 20).toBe(true);
  });

  it('share a seam’s colour on both sides, and skip edges that are not there', () => {
    const pieces = [square('a', 0, 0, 10), square('b', 20, 0, 10)];
    const lines = seamLines(pieces, [
      {
        id: 's',
        a: [{ piece: 'a', edge: 'e0' }],
        b: [
          { piece: 'b', edge: 'e0' },
          { piece: 'b', edge: 'gone' },
        ],
      },
    ]);
    expect(lines.map((line) => [line.piece, line.side, line.index])).toEqual([
      ['a', 'a', 0],
      ['b', 'b', 0],
    ]);
    expect(seamHue(0)).not.toBe(seamHue(1));
  });

  it('have the fabric’s colour', () => {
    expect(cssColour([1, 0, 0.214])).toBe('rgb(255 0 127)');
  });
});

describe('the flat view', () => {
  it('fits a box and zooms about the pointer', () => {
    const view = fit({ minX: 0, minY: 0, maxX: 1000, maxY: 500 }, 556, 456);
    expect(view).toEqual({ x: 500, y: -250, scale: 0.5 });
    const closer = zoomed(view, 2, 100, 0);
    expect(closer.scale).toBe(1);
    expect(closer.x + 100 / closer.scale).toBeCloseTo(view.x + 100 / view.scale, 9);
    expect(panned(view, 50, 0).x).toBe(400);
    expect(zoomed(view, 1e9).scale).toBe(20);
  });
});

describe('meshes from the service', () => {
  it('are read with their counts checked', () => {
    const bytes = new ArrayBuffer(8 + 36 + 12);
    new Uint32Array(bytes, 0, 2).set([3, 1]);
    new Float32Array(bytes, 8, 9).set([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    new Uint32Array(bytes, 44, 3).set([0, 1, 2]);
    expect([...decodeBody(bytes).indices]).toEqual([0, 1, 2]);
    new Uint32Array(bytes, 44, 3).set([0, 1, 3]);
    expect(() => decodeBody(bytes)).toThrow(RangeError);
    expect(() => decodeBody(bytes.slice(0, 50))).toThrow(RangeError);
    expect(() => decodeBody(new ArrayBuffer(3))).toThrow(RangeError);
  });

  it('give an ended drape its cloth, sewn where it lies together', () => {
    const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\no front\nf 1 2 3\no back\nf 4/1 6/1 5/1\n';
    const { topology, positions: xyz } = clothFromObj(text, (piece) => (piece === 'front' ? [1, 0, 0] : null));
    expect(topology.pieces.map(({ id, firstVertex, vertexCount }) => [id, firstVertex, vertexCount])).toEqual([
      ['front', 0, 3],
      ['back', 3, 3],
    ]);
    expect([...topology.sewn]).toEqual([1, 3, 2, 4]);
    expect(xyz.length).toBe(18);
    expect(() => clothFromObj('v 0 0 0\nf 1 2 3\n', () => null)).toThrow(RangeError);
    expect(() => clothFromObj('', () => null)).toThrow(RangeError);
  });
});
