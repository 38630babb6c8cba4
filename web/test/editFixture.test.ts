// The page's own idea of edits, held to what the service makes of them: tests/core/project/editing reads the same file.

import { describe, expect, it } from 'vitest';
import fixture from '../../proto/fixtures/edits/edits.json';
import type { Curve, Edit, Piece, PieceEdge, Point } from '../src/api/types';
import { Commands } from '../src/commands/Commands';
import { AppState, ready } from '../src/state/AppState';
import type { Part } from '../src/state/editing';
import { jointsOf, lengthOfCurves, straight } from '../src/state/outline';
import { points } from '../src/tools/points';
import { fakeApi, pieceOf, projectOf } from './fakes';

interface EdgeText {
  id: string;
  points?: Point[];
  curves?: Curve[];
  length_mm?: number;
}

interface EditCase {
  name: string;
  start: string;
  asked: 'drag' | 'remove' | 'bend' | 'insert';
  part?: Part;
  clicked?: Point;
  edits: Edit[];
  changed: EdgeText[];
  gone?: string[];
}

const cases = fixture.cases as unknown as EditCase[];
const starts = fixture.starts as unknown as Record<string, { outline: EdgeText[]; holes: EdgeText[][] }>;

/** A line through points, or curves. */
const curvesOf = ({ points: line = [], curves }: EdgeText): Curve[] =>
  curves ?? line.slice(1).map((to, i) => straight(line[i]!, to));

const edgeOf = (text: EdgeText, loop: number): PieceEdge => {
  const curves = curvesOf(text);
  const edge = { id: text.id, curves, points: [], length_mm: lengthOfCurves(curves), loop };
  return { ...edge, points: jointsOf(edge) };
};

function pieceAt(start: string): Piece {
  const { outline, holes } = starts[start]!;
  const edges = [outline, ...holes].flatMap((loop, i) => loop.map((text) => edgeOf(text, i)));
  return { ...pieceOf('front', []), edges };
}

/** The piece after a case, as the service has it. */
function after({ start, changed, gone = [] }: EditCase): Map<string, Curve[]> {
  const edges = new Map(pieceAt(start).edges.map((edge) => [edge.id, edge.curves]));
  for (const edge of changed) edges.set(edge.id, curvesOf(edge));
  for (const id of gone) edges.delete(id);
  return edges;
}

/** A page that shows the piece, and what it sends. */
function begin(start: string) {
  const state = new AppState();
  const sent: Edit[][] = [];
  const api = fakeApi({
    edit: (id, revision, edits) => {
      sent.push(edits);
      return Promise.resolve(projectOf({ id, revision: revision + 1 }));
    },
  });
  const nothing = (): void => undefined;
  const commands = new Commands(state, api, { go: nothing, save: nothing, newKey: () => '', anew: nothing, say: nothing, follow: nothing }, nothing, nothing);
  state.projects.value = ready([projectOf()]);
  state.jobs.value = ready([]);
  state.route.value = { name: 'project', id: 'p_1' };
  const piece = pieceAt(start);
  state.pieces.value = ready({ pieces: [piece], seams: [] });
  return { hand: { state, commands }, sent, piece };
}

const settle = (): Promise<void> => new Promise((done) => setTimeout(done, 0));

/** The part that an edit moves, and where to. */
function moved(edit: Edit): { part: Part; to: Point } {
  if (edit.edit === 'move_point') {
    const { piece, edge, point, to } = edit;
    return { part: { kind: 'point', piece, edge, point }, to };
  }
  if (edit.edit !== 'move_handle') throw new Error(`${edit.edit} is no drag`);
  const { piece, edge, curve, handle, to } = edit;
  return { part: { kind: 'handle', piece, edge, curve, handle: handle as 1 | 2 }, to };
}

const placeOf = (piece: Piece, part: Part): Point => {
  const edge = piece.edges.find((one) => one.id === part.edge)!;
  if (part.kind === 'handle') return edge.curves[part.curve]![part.handle];
  return jointsOf(edge)[part.kind === 'point' ? part.point : 0]!;
};

/** Drags as the hand does: shown on the way, sent when it is let go. */
async function drag(one: EditCase) {
  const { hand, sent, piece } = begin(one.start);
  const { part, to } = moved(one.edits[0]!);
  const was = placeOf(piece, part);
  const grip = points.grab!(hand, part, was);
  const held = grip.to([to[0] - was[0], to[1] - was[1]], { shift: false, alt: true, reach: 0 });
  await grip.drop(held);
  return { sent, shown: held.shown(piece) };
}

/** What the page sends for one of the other cases. */
async function ask(one: EditCase): Promise<Edit[][]> {
  const { hand, sent } = begin(one.start);
  const { pattern } = hand.commands;
  if (one.asked === 'insert') points.edges!.double!(hand, { piece: 'front', edge: edgeNamed(one) }, one.clicked!);
  if (one.part) pattern.selectPart(one.part);
  if (one.asked === 'remove') await pattern.remove();
  if (one.asked === 'bend') await pattern.bendOrStraighten('front', one.part!.edge);
  await settle();
  return sent;
}

const edgeNamed = ({ edits }: EditCase): string => {
  const [edit] = edits;
  return edit && 'edge' in edit ? edit.edge : '';
};

/** Numbers as near as the service's are to the file's. */
const near = (value: unknown): unknown => {
  if (typeof value === 'number') return expect.closeTo(value, 8);
  if (Array.isArray(value)) return value.map(near);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, near(one)]));
};

describe('a drag is shown as the service will have it', () => {
  it.each(cases.filter(({ asked }) => asked === 'drag'))('$name', async (one) => {
    const { sent, shown } = await drag(one);
    expect(sent).toEqual([one.edits]);
    const wanted = after(one);
    expect(shown.edges.map((edge) => edge.id)).toEqual([...wanted.keys()]);
    for (const edge of shown.edges) expect(edge.curves, edge.id).toEqual(near(wanted.get(edge.id)));
  });

  it.each(cases.filter(({ asked }) => asked === 'drag'))('with its lengths to 0.1 %: $name', async (one) => {
    const { shown } = await drag(one);
    for (const { id, length_mm } of one.changed) {
      const edge = shown.edges.find((other) => other.id === id)!;
      expect(Math.abs(edge.length_mm / length_mm! - 1)).toBeLessThan(1e-3);
    }
  });
});

describe('the hand asks for the edits that the service does', () => {
  it.each(cases.filter(({ asked }) => asked !== 'drag'))('$name', async (one) => {
    expect(await ask(one)).toEqual([near(one.edits)]);
  });

  it('has cases of every kind', () => {
    expect(new Set(cases.map(({ asked }) => asked))).toEqual(new Set(['drag', 'remove', 'bend', 'insert']));
  });
});
