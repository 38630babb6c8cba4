import { Color, Group, BufferAttribute, BufferGeometry, GreaterDepth, LessEqualDepth, LineSegments, Points, type Material } from 'three';
import { describe, expect, it } from 'vitest';
import type { ClothTopology } from '../src/api/frames';
import { ClothLines } from '../src/scene/ClothLines';

/** One piece, a square of two triangles, 10 cm. */
const topology: ClothTopology = {
  vertexCount: 4,
  triangles: Uint32Array.from([0, 1, 2, 0, 2, 3]),
  rest: Float32Array.from([0, 0, 0.1, 0, 0.1, 0.1, 0, 0.1]),
  sewn: new Uint32Array(0),
  pieces: [{ id: 'a', firstVertex: 0, vertexCount: 4, colour: [1, 1, 1] }],
} as unknown as ClothTopology;

function lines() {
  const group = new Group();
  const surface = new BufferGeometry();
  surface.setAttribute('position', new BufferAttribute(new Float32Array(12), 3));
  const made = new ClothLines(group, new Color('blue'), new Color('blue'));
  made.set(topology, surface);
  return { group, made };
}

type Drawn = LineSegments | Points;
function shown(group: Group, kind: typeof Points | typeof LineSegments): Drawn[] {
  const drawn = group.children.filter((one) => one instanceof kind) as Drawn[];
  return drawn.filter(({ visible, geometry }) => visible && (geometry.index?.count ?? 0) > 0);
}

/** The vertex shader that is made of a plain one. */
function shaderOf(material: Material): string {
  const shader = { vertexShader: '#include <project_vertex>' };
  material.onBeforeCompile(shader as never, undefined as never);
  return shader.vertexShader;
}

describe('what is lit on the cloth', () => {
  it.each([
    ['a seam', Points, (made: ClothLines) => made.outlineSeam([{ piece: 'a', edge: 'e0', side: 'a', points: [[0, 0], [100, 0]] }])],
    ['a piece', LineSegments, (made: ClothLines) => made.outlinePiece(topology.pieces[0])],
  ] as const)('is seen where nothing lies before it, and faint where something does: %s', (_, kind, light) => {
    const { group, made } = lines();
    const before = shown(group, kind).length;
    light(made);
    const [front, behind] = shown(group, kind).slice(before).map(({ material }) => material as Material);
    expect([front!.depthTest, front!.depthFunc, front!.opacity]).toEqual([true, LessEqualDepth, 1]);
    expect([behind!.depthTest, behind!.depthFunc, behind!.depthWrite]).toEqual([true, GreaterDepth, false]);
    expect(behind!.opacity).toBeLessThan(0.3);
  });

  it('is not hidden by the cloth that it lies on: it stands a little nearer to the eye', () => {
    const { group, made } = lines();
    made.outlineSeam([{ piece: 'a', edge: 'e0', side: 'a', points: [[0, 0], [100, 0]] }]);
    for (const { material } of shown(group, Points)) expect(shaderOf(material as Material)).toMatch(/mvPosition\.xyz \* \(1\.0 - 0\.012/);
  });
});
