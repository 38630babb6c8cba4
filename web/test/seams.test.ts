import { describe, expect, it } from 'vitest';
import type { Edit } from '../src/api/types';
import { findPart, freePieceId } from '../src/state/editing';
import { stepText, turnsOf, withSewn, type Known } from '../src/state/steps';
import {
  alongLine,
  alongSide,
  clash,
  emptyDraft,
  freeSeamId,
  lengthsText,
  seamLengths,
  seamMarks,
  seamParts,
  seamsOfEdge,
  sewnTogether,
  toWear,
  ticked,
  withEdge,
} from '../src/state/seamView';
import { seamOf, squareOf } from './fakes';
import { fabricOf } from './samples';

const pieces = [squareOf('a', 0, 0, 100), squareOf('b', 200, 0, 100)];

describe('a seam on the pieces', () => {
  it('has its threads on its edges also where a side goes over two pieces', () => {
    const apart = [...pieces, squareOf('c', 500, 0, 100)];
    const seam = { ...seamOf('s', ['a', 'e1'], ['b', 'e3']), b: [{ piece: 'b', edge: 'e3' }, { piece: 'c', edge: 'e3' }] };
    const side = seamParts(apart, seam).filter((part) => part.side === 'b');
    const xs = [0, 0.25, 0.5, 0.75, 1].map((place) => alongSide(side, place)![0]);
    expect(xs.every((x) => side.some((part) => part.points.every(([own]) => own === x)))).toBe(true);
    expect(new Set(xs).size).toBe(2);
  });

  it('has marks that run the same way on both sides', () => {
    // Right side of a to left side of b, as they lie beside each other.
    const [a, b] = seamParts(pieces, seamOf('s', ['a', 'e1'], ['b', 'e3']));
    expect([a!.points[0], a!.points.at(-1)]).toEqual([
      [100, 0],
      [100, 100],
    ]);
    expect([b!.points[0], b!.points.at(-1)]).toEqual([
      [200, 0],
      [200, 100],
    ]);
    expect(seamMarks([a!, b!], 2000)).toEqual([]);
    const marks = seamMarks([a!, b!], 1000);
    expect(marks.map((mark) => mark.along)).toEqual([
      [0, 1],
      [0, 1],
    ]);
    const [, turned] = seamParts(pieces, seamOf('s', ['a', 'e1'], ['b', 'e3'], { same_direction: true }));
    expect(turned!.points[0]).toEqual([200, 100]);
  });

  it('goes through a series in the order in which it closes', () => {
    const seam = {
      ...seamOf('s', ['a', 'e1'], ['b', 'e3']),
      b: [
        { piece: 'b', edge: 'e2' },
        { piece: 'b', edge: 'e3' },
      ],
    };
    const [, first, second] = seamParts(pieces, seam);
    expect([first!.edge, second!.edge]).toEqual(['e3', 'e2']);
    expect(first!.points.at(-1)).toEqual(second!.points[0]);
    expect(seamLengths(pieces, seam)).toEqual({ a: 100, b: 200, ease: 1 });
  });

  it('is of a part of an edge where it says so, and skips edges that are not there', () => {
    const seam = { ...seamOf('s', ['a', 'e1'], ['b', 'gone']), a: [{ piece: 'a', edge: 'e1', from: 0.5, to: 1 }] };
    const parts = seamParts(pieces, seam);
    expect(parts.map((part) => part.points)).toEqual([
      [
        [100, 50],
        [100, 100],
      ],
    ]);
  });

  it('tells both lengths and their difference', () => {
    expect(lengthsText(412.4, 398)).toEqual({ lengths: '412.4 ⇄ 398.0 mm', difference: '14.4 mm (3.6 %)' });
    expect(lengthsText(50, 50.02)).toEqual({ lengths: '50.0 ⇄ 50.0 mm', difference: 'equal' });
    expect(
      alongLine(
        [
          [0, 0],
          [10, 0],
        ],
        0.5,
      ),
    ).toEqual({ at: [5, 0], along: [1, 0] });
    expect(alongLine([], 0.5)).toBeNull();
  });

  it('is found by its edges', () => {
    const seams = [seamOf('s', ['a', 'e1'], ['b', 'e3']), seamOf('t', ['a', 'e0'], ['b', 'e0'])];
    expect(seamsOfEdge(seams, 'b', 'e3')).toEqual([0]);
    expect(seamsOfEdge(seams, 'b', 'e1')).toEqual([]);
    expect(freeSeamId([{ id: 'seam3' }, { id: 'x' }])).toBe('seam4');
  });
});

describe('proposals', () => {
  const of = (id: string, a: [string, string], b: [string, string], confidence: number) => ({
    ...seamOf(id, a, b),
    confidence,
    to_wear: confidence >= 0.9,
  });
  const all = [
    of('s0', ['a', 'e0'], ['b', 'e0'], 0.9),
    of('s1', ['a', 'e0'], ['b', 'e2'], 0.85),
    of('s2', ['a', 'e1'], ['b', 'e2'], 0.3),
  ];

  it('that want the same edge are not ticked together', () => {
    expect([...sewnTogether(all, 0.8)]).toEqual(['s0']);
    expect([...sewnTogether(all, 0)]).toEqual(['s0', 's2']);
    expect([...toWear(all)]).toEqual(['s0']);
    expect([...ticked(all, new Set(['s0', 's2']), 's1', true)]).toEqual(['s1']);
    expect([...ticked(all, new Set(['s0']), 's0', false)]).toEqual([]);
  });

  it('may share an edge by its parts', () => {
    const part = (id: string, from: number, to: number) => ({ id, a: [{ piece: 'a', edge: 'e', from, to }], b: [] });
    expect(clash(part('x', 0, 0.5), part('y', 0.5, 1))).toBe(false);
    expect(clash(part('x', 0, 0.6), part('y', 0.5, 1))).toBe(true);
  });
});

describe('a seam that is clicked together', () => {
  it('collects edges for one side, then for the other, and gives them back', () => {
    const one = withEdge(emptyDraft, 'a', 'e1');
    expect(one.a).toEqual([{ piece: 'a', edge: 'e1' }]);
    expect(withEdge(one, 'a', 'e1').a).toEqual([]);
    const two = withEdge({ ...one, side: 'b' }, 'b', 'e3');
    expect(two.b).toEqual([{ piece: 'b', edge: 'e3' }]);
    expect(withEdge(two, 'a', 'e1')).toMatchObject({ a: [], b: [{ piece: 'b' }] });
  });
});

describe('the history', () => {
  // Its words look at names only, also at those of a newer service.
  const editOf = (edit: string, more: object = {}) => ({ edit, ...more }) as Edit;
  const step = (number: number, undone: boolean, edit: string) => ({
    number,
    undone,
    created_ms: 0,
    edits: [editOf(edit, { piece: 'front', edge: 'hem' })],
  });

  const nobody: Known = { pieces: [], seams: new Map(), fabrics: [] };

  it('says what undo and redo would do', () => {
    expect(turnsOf([], nobody)).toEqual({ undo: null, redo: null });
    const history = [step(4, true, 'split_edge'), step(3, true, 'bend_edge'), step(2, false, 'move_point')];
    expect(turnsOf(history, nobody)).toEqual({ undo: 'Move point, front · hem', redo: 'Make a curve, front · hem' });
  });

  it('counts edits of one step', () => {
    const seam = editOf('add_seam', { id: 's' });
    expect(stepText([seam, seam, seam], nobody)).toBe('Add seam × 3');
    expect(stepText([editOf('join_edges'), editOf('delete_point')], nobody)).toBe('Join edges and 1 more');
    expect(stepText([editOf('knit_sleeve')], nobody)).toBe('knit sleeve');
    expect(stepText([editOf('restore', { pieces: {}, attachments: {} })], nobody)).toBe('Place pieces');
    expect(stepText([editOf('restore', { bodies: {} })], nobody)).toBe('Change body');
  });

  it('says which fabric was chosen', () => {
    const known: Known = { ...nobody, fabrics: [fabricOf('denim', { title: 'Denim' })] };
    const cut = (piece: string, fabric = 'denim'): Edit => editOf('set_fabric', { piece, fabric });
    expect(stepText([cut('front')], known)).toBe('Change fabric, front: Denim');
    expect(stepText([cut('front'), cut('back')], known)).toBe('Change fabric × 2: Denim');
    expect(stepText([cut('front'), cut('back', 'own')], known)).toBe('Change fabric × 2');
    expect(stepText([cut('front', 'own')], known)).toBe('Change fabric, front: own');
  });

  it('names seams and edges as a pattern maker does, also those that are gone', () => {
    const pieces = [squareOf('front', 0, 0, 100), squareOf('back', 200, 0, 100)];
    const sides = seamOf('seam12', ['front', 'e1'], ['back', 'e3']);
    const known: Known = { pieces, seams: new Map([[sides.id, sides], ['yoke', seamOf('yoke', ['front', 'e2'], ['back', 'e2'])]]), fabrics: [] };
    const reversed = (seam: string): string => stepText([editOf('reverse_seam', { seam })], known);
    expect(reversed('seam12')).toBe('Reverse seam, front · right to back · left');
    expect(reversed('yoke')).toBe('Reverse seam, yoke');
    expect(reversed('seam99')).toBe('Reverse seam');
    expect(stepText([editOf('bend_edge', { piece: 'front', edge: 'e2' })], known)).toBe('Make a curve, front · top');
    const added = { ...step(1, false, ''), edits: [editOf('add_seam', { ...seamOf('seam99', ['front', 'e0'], ['back', 'e0']) })] };
    expect(stepText(added.edits, known)).toBe('Add seam, front · bottom to back · bottom');
    const told = withSewn(known, [added]);
    expect(stepText([editOf('remove_seam', { seam: 'seam99' })], told)).toBe('Remove seam, front · bottom to back · bottom');
  });
});

describe('what is selected', () => {
  it('is found in the pieces as they are now', () => {
    const part = { kind: 'point', piece: 'a', edge: 'e1', point: 1 } as const;
    expect(findPart(pieces, part)?.at).toEqual([100, 100]);
    expect(findPart(pieces, { kind: 'handle', piece: 'a', edge: 'e0', curve: 0, handle: 2 })?.at?.[0]).toBeCloseTo(
      66.67,
      2,
    );
    expect(findPart(pieces, { ...part, point: 5 })).toBeNull();
    expect(findPart(pieces, { ...part, piece: 'gone' })).toBeNull();
    expect(freePieceId([{ id: 'a' }, { id: 'a_2' }], 'a')).toBe('a_3');
  });
});
