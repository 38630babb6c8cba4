import { describe, expect, it } from 'vitest';
import type { Piece, Point, SeamEdge } from '../src/api/types';
import { edgeTitles, edgeWords, seamTitle, seamWords, seriesText } from '../src/state/seamNames';
import { pieceOf, seamOf, squareOf } from './fakes';

const pieces = [squareOf('a', 0, 0, 100), squareOf('b', 200, 0, 100)];
const use = (piece: string, edge: string, part: Partial<SeamEdge> = {}): SeamEdge => ({ piece, edge, ...part });

/** Half of a shirt as it is drafted: hem, side, armhole, shoulder, neck, the same on the other side. */
const bodice = (id: string): Piece =>
  pieceOf(id, [
    [-25, 0],
    [25, 0],
    [25, 40],
    [20, 62],
    [8, 66],
    [-8, 66],
    [-20, 62],
    [-25, 40],
  ]);

describe('an edge', () => {
  it('without a name is called by where it lies on its piece', () => {
    const [a] = pieces;
    expect(a!.edges.map(({ id }) => edgeWords(a, id))).toEqual(['bottom', 'right', 'top', 'left']);
    const named = { ...a!, edges: [{ ...a!.edges[0]!, id: 'waist' }] };
    expect(edgeWords(named, 'waist')).toBe('waist');
    expect(edgeWords(undefined, 'e1')).toBe('e1');
  });

  it('that lies at the same place as another is told apart by which lies further out', () => {
    expect([...edgeTitles(bodice('front')).values()]).toEqual([
      'bottom',
      'right',
      'top right, lower',
      'top right, higher',
      'top',
      'top left, higher',
      'top left, lower',
      'left',
    ]);
    const skirt = pieceOf('skirt', [
      [0, 0],
      [50, 0],
      [100, 0],
      [100, 100],
      [0, 100],
    ]);
    expect([...edgeTitles(skirt).values()].slice(0, 2)).toEqual(['bottom left', 'bottom right']);
    const hem = { ...skirt, edges: [33, 50, 67].map((x, i) => ({ ...skirt.edges[0]!, id: `e${i}`, points: [[x, 0]] as Point[] })) };
    expect([...edgeTitles(hem).values()]).toEqual(['bottom (1)', 'bottom (2)', 'bottom (3)']);
    expect([...edgeTitles({ ...hem, edges: hem.edges.slice(1) }).values()]).toEqual(['bottom, further left', 'bottom, further right']);
  });
});

describe('a seam', () => {
  it('is called by its number and its name, or by the pieces that it joins', () => {
    const named = seamOf('side_left', ['a', 'e1'], ['b', 'e3']);
    const given = { ...named, id: 'seam7', b: [use('b', 'e3'), use('c', 'e0')] };
    const tube = seamOf('seam8', ['a', 'e1'], ['a', 'e3']);
    const sewn = { pieces, seams: [named, given, tube] };
    expect(sewn.seams.map(({ id }) => seamTitle(sewn, id))).toEqual(['1 side_left', '2 a to b and c', '3 a, to itself']);
    expect(seamTitle(sewn, 'gone')).toBe('gone');
  });

  it('is told by its place from others between the same pieces, whichever of them comes first', () => {
    const shirt = [bodice('front'), bodice('back')];
    const seams = [
      seamOf('s0', ['front', 'e3'], ['back', 'e5']),
      seamOf('s1', ['back', 'e3'], ['front', 'e5']),
      seamOf('s2', ['front', 'e1'], ['back', 'e7']),
      { ...seamOf('s3', ['front', 'e7'], ['back', 'e1']), a: [use('front', 'e6'), use('front', 'e7')] },
      seamOf('hem', ['front', 'e0'], ['back', 'e0']),
    ];
    const sewn = { pieces: shirt, seams };
    expect(seams.map(({ id }) => seamTitle(sewn, id))).toEqual([
      '1 front · top right to back · top left',
      '2 back · top right to front · top left',
      '3 front · right to back · left',
      '4 front · left to back · right',
      '5 hem',
    ]);
  });

  it('that closes a dart says so, and which of two at the same place', () => {
    // Two darts from the waist of a skirt, legs e1 e2 and e4 e5.
    const skirt = pieceOf('skirt', [[0, 0], [30, 0], [35, 40], [40, 0], [60, 0], [65, 40], [70, 0], [100, 0], [100, 100], [0, 100]]);
    const seams = [seamOf('s0', ['skirt', 'e1'], ['skirt', 'e2']), seamOf('s1', ['skirt', 'e4'], ['skirt', 'e5'])];
    const sewn = { pieces: [skirt], seams };
    expect(seams.map(({ id }) => seamTitle(sewn, id))).toEqual([
      '1 skirt, dart · bottom, further left',
      '2 skirt, dart · bottom, further right',
    ]);
    expect(seamTitle({ ...sewn, seams: seams.slice(1) }, 's1')).toBe('1 skirt, dart · bottom');
    // Two sides of a corner make a bag, not a dart.
    expect(seamTitle({ ...sewn, seams: [seamOf('s0', ['skirt', 'e7'], ['skirt', 'e8'])] }, 's0')).toBe('1 skirt, to itself');
  });

  it('over many edges is called by the place of its sides, or by their pieces where those are many', () => {
    const run = { ...seamOf('s1', ['a', 'e0'], ['b', 'e3']), a: [use('a', 'e0'), use('a', 'e1')] };
    expect(seamWords(run, { pieces, seams: [run] })).toBe('a · bottom right to b · left');
    const series = ['a', 'b', 'c'].map((piece) => use(piece, 'e0'));
    expect(seamWords({ ...run, a: series }, { pieces, seams: [] })).toBe('a and b and c to b · left');
  });

  it('names each edge of a side, and which part of it', () => {
    const side = seamOf('s', ['a', 'e1'], ['b', 'e3']);
    expect(`${seriesText(side.a, pieces)} to ${seriesText(side.b, pieces)}`).toBe('a · right to b · left');
    expect(seriesText([use('a', 'e1', { from: 0.5, to: 1 })])).toBe('a · e1 (50–100 %)');
  });
});
