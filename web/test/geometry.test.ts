import { describe, expect, it } from 'vitest';
import { decodeBody } from '../src/api/body';
import { clothFromObj } from '../src/api/objCloth';
import { nameThatFits } from '../src/pattern/PieceShape';
import { tagAt } from '../src/pattern/PieceTags';
import { fit, panned, zoomed } from '../src/pattern/Viewport';
import { boundsOf, footprints, poseFor } from '../src/scene/framing';
import { rimEdges, seamEdges, shareNormals, vertexNormals, verticesAlong, weldGroups, widestGap } from '../src/scene/surface';
import { cssColour, cutLine, insideOf, spanAt } from '../src/state/patternGeometry';

/** Two squares that meet at x = 1 at a right angle; vertices 1, 2 are sewn to 4, 7. */
const positions = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, -1, 1, 1, -1, 1, 1, 0]);
const triangles = new Uint32Array([0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7]);
const sewn = new Uint32Array([1, 4, 2, 7]);

describe('a seam in the cloth', () => {
  it('is found among the vertices of its pieces’ rims by their flat places', () => {
    const piece = (id: string, firstVertex: number) => ({ id, firstVertex, vertexCount: 3, colour: [1, 1, 1] as const });
    // Two triangles with the same flat places, m.
    const flat = [0, 0, 0.1, 0, 0, 0.1];
    const topology = { pieces: [piece('a', 0), piece('b', 3)], rest: new Float32Array([...flat, ...flat]) };
    const rim = new Uint32Array([0, 1, 1, 2, 2, 0, 3, 4, 4, 5, 5, 3]);
    const part = { piece: 'b', edge: 'e0', side: 'a', points: [[-50, 0], [100, 0]] } as const;
    expect(verticesAlong([part] as never, topology as never, rim)).toEqual([3, 4]);
  });
});

describe('the cloth’s surface', () => {
  it('has one normal over a closed seam and its own on either side of an open one', () => {
    const normals = new Float32Array(24);
    vertexNormals(positions, triangles, normals);
    shareNormals(positions, weldGroups(sewn, 8), normals);
    expect([...normals.slice(3, 6)]).toEqual([...normals.slice(12, 15)]);
    expect(Math.min(normals[3]!, normals[5]!)).toBeGreaterThan(0.4);
    const open = positions.slice();
    open[12] = 1.5;
    open[21] = 1.5;
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

describe('the ground', () => {
  it('is darker under both feet of a body that stands on it, and under none that hangs', () => {
    const feet = [-0.2, 0.01, 0, -0.1, 0, 0.2, 0.1, 0, 0, 0.2, 0.02, 0.2];
    const body = new Float32Array([...feet, 0, 1.7, 0]);
    const [left, right] = footprints(body);
    expect(left!.x).toBeCloseTo(0.15);
    expect(right!.x).toBeCloseTo(-0.15);
    expect(left!.along).toBeCloseTo(0.1);
    expect(footprints(new Float32Array([0, 1, 0, 0, 2, 0]))).toEqual([]);
  });
});

describe('flat pieces', () => {
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

  it('are as wide as their cloth where the name stands', () => {
    const trousers: [number, number][] = [[0, 0], [40, 0], [50, 60], [60, 0], [100, 0], [100, 100], [0, 100]];
    expect(spanAt(trousers, [20, 30])).toBe(45);
    expect(spanAt(trousers, [80, 30])).toBe(45);
    expect(spanAt(trousers, [50, 80])).toBe(100);
    expect(spanAt(trousers, [-5, 30])).toBe(0);
  });

  it('have as much of their name as fits', () => {
    expect(nameThatFits('sleeve', 60)).toBe('sleeve');
    expect(nameThatFits('left_sleeve_back', 70)).toBe('left_s…ack');
    expect([7, 8].map((n) => nameThatFits(`skirt_panel_${n}`, 70))).toEqual(['skirt_…l_7', 'skirt_…l_8']);
    expect(nameThatFits('left_sleeve_back', 20)).toBe('');
  });

  it('have their name above them where it is told aside, else below, and within what is seen', () => {
    const seen = { minX: 0, minY: 0, maxX: 100, maxY: 100 };
    const at = (minX: number, minY: number) => tagAt({ minX, minY, maxX: minX + 10, maxY: minY + 10 }, 40, seen, 2);
    expect(at(45, 45)).toEqual([50, 63]);
    expect(at(45, 85)).toEqual([50, 77]);
    expect([at(0, 45)[0], at(90, 45)[0]]).toEqual([20, 80]);
  });

  it('give the part of a line between two fractions of its length', () => {
    const bent: [number, number][] = [
      [0, 0],
      [10, 0],
      [10, 10],
    ];
    expect(cutLine(bent, 0, 1)).toEqual(bent);
    expect(cutLine(bent, 0.25, 0.75)).toEqual([
      [5, 0],
      [10, 0],
      [10, 5],
    ]);
    expect(cutLine(bent, 0.75, 1)).toEqual([
      [10, 5],
      [10, 10],
    ]);
  });

  it('have the fabric’s colour', () => {
    expect(cssColour([1, 0, 0.214])).toBe('rgb(255 0 127)');
  });
});

describe('the flat view', () => {
  const even = { side: 28, top: 28, bottom: 28 };

  it('fits a box and zooms about the pointer', () => {
    const view = fit({ minX: 0, minY: 0, maxX: 1000, maxY: 500 }, { width: 556, height: 456 }, even);
    expect(view).toEqual({ x: 500, y: -250, scale: 0.5 });
    const below = fit({ minX: 0, minY: 0, maxX: 500, maxY: 500 }, { width: 956, height: 556 }, { ...even, top: 128 });
    expect(below.scale).toBeCloseTo(0.8, 9);
    expect(below.y).toBeCloseTo(-312.5, 9); // its top at 128 px: the margin under what is covered
    const between = fit({ minX: 0, minY: 0, maxX: 500, maxY: 500 }, { width: 956, height: 556 }, { side: 28, top: 128, bottom: 128 });
    expect([between.scale, between.y]).toEqual([0.6, -250]);
    const closer = zoomed(view, 2, 100, 0);
    expect(closer.scale).toBe(1);
    expect(closer.x + 100 / closer.scale).toBeCloseTo(view.x + 100 / view.scale, 9);
    expect(panned(view, 50, 0).x).toBe(400);
    expect(zoomed(view, 1e9).scale).toBe(20);
    expect(zoomed(view, 1e-9).scale).toBe(0.02);
  });

  it('shows pieces of thirty metres whole, and zooms in on them', () => {
    const giant = fit({ minX: 0, minY: 0, maxX: 15_000, maxY: 30_000 }, { width: 556, height: 456 }, even);
    expect(giant.scale).toBeCloseTo(400 / 30_000, 9);
    expect(zoomed(giant, 0.5).scale).toBe(giant.scale);
    expect(zoomed(giant, 2).scale).toBeCloseTo(2 * giant.scale, 9);
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
    const { topology, positions: xyz } = clothFromObj(text, [{ id: 'front', colour: [1, 0, 0] }]);
    expect(topology.pieces.map(({ id, firstVertex, vertexCount }) => [id, firstVertex, vertexCount])).toEqual([
      ['front', 0, 3],
      ['back', 3, 3],
    ]);
    expect([...topology.sewn]).toEqual([1, 3, 2, 4]);
    expect(xyz.length).toBe(18);
    expect([...topology.rest.slice(2, 4)]).toEqual([xyz[3], xyz[4]]); // without flat places: as seen from ahead
    const flat = clothFromObj(`${text}vt 5 6\n${'vt 7 8\n'.repeat(5)}`, []).topology.rest;
    expect([...flat.slice(0, 4)]).toEqual([5, 6, 7, 8]);
    const plain = clothFromObj(text.replace(/^o .*$/gm, ''), [{ id: 'front', colour: [1, 0, 0] }]).topology; // no piece would be drawn black
    expect(plain.pieces).toEqual([{ id: '', firstVertex: 0, vertexCount: 6, colour: [1, 0, 0] }]);
    expect(() => clothFromObj('v 0 0 0\nf 1 2 3\n', [])).toThrow(RangeError);
    expect(() => clothFromObj('', [])).toThrow(RangeError);
  });

  it('give pieces whose names OBJ cannot hold their own again, with their colour', () => {
    const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\no left_sleeve\nf 1 2 3\n';
    const { pieces } = clothFromObj(text, [{ id: 'left sleeve', colour: [0, 0.5, 1] }]).topology;
    expect(pieces).toEqual([{ id: 'left sleeve', firstVertex: 0, vertexCount: 3, colour: [0, 0.5, 1] }]);
  });
});
