import { describe, expect, it } from 'vitest';
import type { Api } from '../src/api/Api';
import { ApiError } from '../src/api/http';
import type { Edit } from '../src/api/types';
import { EditQueue } from '../src/commands/EditQueue';
import { PatternCommands } from '../src/commands/PatternCommands';
import { SeamCommands } from '../src/commands/SeamCommands';
import { AppState, ready, valueOf } from '../src/state/AppState';
import { sew } from '../src/tools/sew';
import { fakeApi, projectOf, seamOf, squareOf } from './fakes';

function begin(more: Partial<Api> = {}) {
  const state = new AppState();
  const sent: { revision: number; edits: Edit[] }[] = [];
  const api = fakeApi({
    edit: async (id, revision, edits) => {
      sent.push({ revision, edits });
      return projectOf({ id, revision: revision + 1 });
    },
    ...more,
  });
  state.projects.value = ready([projectOf()]);
  state.jobs.value = ready([]);
  state.route.value = { name: 'project', id: 'p_1' };
  const pieces = [squareOf('a', 0, 0, 100), squareOf('b', 200, 0, 100)];
  state.pieces.value = ready({ pieces, seams: [seamOf('s', ['a', 'e1'], ['b', 'e3'])] });
  const edits = new EditQueue(state, api, () => undefined);
  return { state, sent, edits, commands: new PatternCommands(state, api, edits), seams: new SeamCommands(state, api, edits) };
}

const move: Edit = { edit: 'move_point', piece: 'a', edge: 'e0', point: 0, to: [1, 2] };

describe('an edit', () => {
  it('names the revision that it was made for, also when they follow each other at once', async () => {
    const { edits, sent, state } = begin();
    await Promise.all([edits.send(move), edits.send(move)]);
    expect(sent.map(({ revision }) => revision)).toEqual([1, 2]);
    expect(state.project.value?.revision).toBe(3);
    expect(state.editing.busy.value).toBe(false);
  });

  it('that is refused says why and where, until the next one', async () => {
    const refuse = new ApiError(422, 'pattern.self_crossing', 'the outline crosses itself', '/edits/0: piece a');
    const answers = [() => Promise.reject(refuse), () => Promise.resolve(projectOf({ revision: 2 }))];
    const { edits, state } = begin({ edit: () => answers.shift()!() });
    await edits.send(move);
    expect(state.editing.problem.value).toBe(refuse);
    expect(state.project.value?.revision).toBe(1);
    await edits.send(move);
    expect(state.editing.problem.value).toBeNull();
  });

  it('that comes too late takes the newest', async () => {
    const { edits, state } = begin({
      edit: () => Promise.reject(new ApiError(412, 'store.conflict', 'changed since')),
      project: async () => projectOf({ revision: 7 }),
    });
    await edits.send(move);
    expect(state.project.value?.revision).toBe(7);
    expect(state.editing.problem.value?.detail).toMatch(/Somebody else/);
  });
});

describe('deleting', () => {
  it('takes a point within an edge out of it, and joins the edges of a corner', async () => {
    const { commands, sent, state } = begin();
    state.editing.part.value = { kind: 'point', piece: 'a', edge: 'e2', point: 0 };
    await commands.remove();
    expect(sent[0]!.edits).toEqual([
      { edit: 'join_edges', piece: 'a', edge: 'e1', next: 'e2' },
      { edit: 'delete_point', piece: 'a', edge: 'e1', point: 1 },
    ]);
  });

  it('is of the seam before the piece, and of nothing when an edge is selected', async () => {
    const { commands, sent, state } = begin();
    state.selected.value = 'a';
    state.editing.part.value = { kind: 'edge', piece: 'a', edge: 'e1' };
    await commands.remove();
    expect(sent).toEqual([]);
    commands.selectSeam('s');
    await commands.remove();
    expect(sent[0]!.edits).toEqual([{ edit: 'remove_seam', seam: 's' }]);
  });
});

describe('sewing', () => {
  it('goes from side A to side B to the seam with Enter', async () => {
    const { commands, seams, sent, state } = begin();
    commands.takeTool(sew);
    await seams.finishSide();
    seams.sewEdge('a', 'e0');
    await seams.finishSide();
    seams.sewEdge('b', 'e0');
    seams.sewEdge('b', 'e1');
    seams.turnDraft();
    await seams.finishSide();
    expect(sent[0]!.edits).toEqual([
      {
        edit: 'add_seam',
        id: 'seam2',
        a: [{ piece: 'a', edge: 'e0' }],
        b: [
          { piece: 'b', edge: 'e0' },
          { piece: 'b', edge: 'e1' },
        ],
        same_direction: true,
      },
    ]);
    expect(state.editing.draft.value.a).toEqual([]);
    expect(state.editing.seam.value).toBe('seam2');
  });

  it('may take a part of an edge', async () => {
    const { commands, seams, sent } = begin();
    commands.takeTool(sew);
    seams.sewEdge('a', 'e0');
    seams.cutDraft('a', 0, 0.25, 0.5);
    seams.cutDraft('a', 0, 0.7, 0.5); // no part
    await seams.finishSide();
    seams.sewEdge('b', 'e0');
    await seams.finishSide();
    expect(sent[0]!.edits[0]).toMatchObject({ a: [{ piece: 'a', edge: 'e0', from: 0.25, to: 0.5 }] });
  });

  it('is put down by Escape, from the inside out', () => {
    const { commands, seams, state } = begin();
    commands.takeTool(sew);
    seams.sewEdge('a', 'e0');
    expect(commands.cancel()).toBe(true);
    expect(state.editing.draft.value.a).toEqual([]);
    expect(state.editing.tool.value).toBe('sew');
    expect(commands.cancel()).toBe(true);
    expect(state.editing.tool.value).toBe('pieces');
    expect(commands.cancel()).toBe(false);
  });

  it('takes the ticked proposals as one step, the sure ones being ticked', async () => {
    const of = (id: string, confidence: number) => ({ ...seamOf(id, ['a', 'e0'], ['b', 'e2']), confidence, to_wear: confidence >= 0.8 });
    const { seams, sent, state } = begin({ proposals: async () => [of('seam0', 0.93), of('seam1', 0.4)] });
    await seams.propose();
    expect([...state.editing.chosen.value]).toEqual(['seam0']);
    seams.choose('seam1', true);
    seams.choose('seam0', false);
    await seams.acceptProposals();
    expect(sent[0]!.edits).toMatchObject([{ edit: 'add_seam', id: 'seam1' }]);
    expect(sent[0]!.edits[0]).not.toHaveProperty('confidence');
  });
});

describe('a proposal', () => {
  const of = (id: string, from: string, to: string) => ({ ...seamOf(id, ['a', from], ['b', to]), confidence: 0.4, to_wear: false });

  it('is sewn by itself; those that are still possible stay, and their ticks', async () => {
    const { seams, sent, state } = begin({ proposals: async () => [of('s1', 'e0', 'e0'), of('s2', 'e0', 'e1'), of('s3', 'e2', 'e2')] });
    await seams.propose();
    seams.choose('s3', true);
    seams.lightProposal(valueOf(state.editing.proposals.value!)![0]!);
    expect(state.litParts.value.map(({ piece, edge }) => `${piece} ${edge}`)).toEqual(['a e0', 'b e0']);
    await seams.acceptProposal('s1');
    expect(sent[0]!.edits).toMatchObject([{ edit: 'add_seam', id: 's1' }]);
    expect(valueOf(state.editing.proposals.value!)!.map(({ id }) => id)).toEqual(['s3']);
    expect([...state.editing.chosen.value]).toEqual(['s3']);
    expect(state.litParts.value).toEqual([]);
  });

  it('that is refused is looked for anew', async () => {
    const refuse = () => Promise.reject(new ApiError(422, 'edit.seam', 'no'));
    const { seams, state } = begin({ proposals: async () => [of('s1', 'e0', 'e0')], edit: refuse });
    await seams.propose();
    await seams.acceptProposal('s1');
    expect(state.editing.problem.value?.code).toBe('edit.seam');
  });
});

describe('pieces', () => {
  it('that were shown apart keep their places when one is moved', async () => {
    const { commands, sent, state } = begin();
    state.editing.offsets.value = new Map([
      ['a', [0, 0]],
      ['b', [50, 0]],
    ]);
    await commands.movePiece('a', [5, 6]);
    expect(sent[0]!.edits).toEqual([
      { edit: 'move_piece', piece: 'b', by: [50, 0] },
      { edit: 'move_piece', piece: 'a', by: [5, 6] },
    ]);
    expect([...state.editing.offsets.value.values()]).toEqual([
      [0, 0],
      [0, 0],
    ]);
  });

  it('are copied beside themselves, and selected', async () => {
    const { commands, sent, state } = begin();
    await commands.duplicatePiece('a', true);
    expect(sent[0]!.edits[0]).toEqual({ edit: 'duplicate_piece', piece: 'a', id: 'a_2', by: [140, 0], mirrored: true });
    expect(state.selected.value).toBe('a_2');
  });

  it('are renamed only when the name is another one', async () => {
    const { commands, sent, state } = begin();
    state.selected.value = 'a';
    await commands.renamePiece('a', ' a ');
    await commands.renamePiece('a', '');
    expect(sent).toEqual([]);
    await commands.renamePiece('a', 'sleeve');
    expect(state.selected.value).toBe('sleeve');
  });

  it('have darts under names that are free, and edges renamed', async () => {
    const { commands, sent, state } = begin();
    await commands.addDart('a', 'e0', 20, 60);
    await commands.addInnerDart('a', [50, 20], [50, 80], 10);
    expect(sent.map(({ edits }) => edits[0])).toMatchObject([
      { edit: 'add_dart', id: 'dart1' },
      { edit: 'add_inner_dart', id: 'dart1' },
    ]);
    await commands.renameEdge('a', 'e0', 'hem');
    expect(state.editing.part.value).toEqual({ kind: 'edge', piece: 'a', edge: 'hem' });
  });

  it('have straight edges bent and bent ones straightened', async () => {
    const { commands, sent, state } = begin();
    await commands.bendOrStraighten('a', 'e0');
    expect(sent[0]!.edits[0]).toMatchObject({ edit: 'bend_edge', curve: 0 });
    const bent = valueOf(state.pieces.value!)!.pieces[0]!;
    bent.edges[0]!.curves[0]![1] = [20, -30];
    await commands.bendOrStraighten('a', 'e0');
    expect(sent[1]!.edits).toEqual([{ edit: 'straighten_edge', piece: 'a', edge: 'e0' }]);
  });
});

describe('the fabrics of a project', () => {
  it('are asked for once, the library’s and its own', async () => {
    const asked: string[] = [];
    const { commands, state } = begin({
      fabrics: async () => [],
      project: async (id) => {
        asked.push(id);
        return projectOf({ id, document: { fabrics: [{ id: 'main', like: 'twill' }] } as never });
      },
    });
    await Promise.all([commands.loadFabrics(), commands.loadFabrics()]);
    await commands.loadFabrics();
    expect(asked).toEqual(['p_1']);
    expect(state.editing.ownFabrics.value).toEqual([{ id: 'main', name: '', like: 'twill', differs: false }]);
    state.editing.clear();
    expect(state.editing.ownFabrics.value).toEqual([]);
  });

  it('are asked for again where that failed', async () => {
    let fails = true;
    const { commands, state } = begin({
      fabrics: async () => [],
      project: async (id) => {
        if (fails) throw new ApiError(0, 'net.unreachable', 'none');
        return projectOf({ id, document: { fabrics: [{ id: 'main' }] } as never });
      },
    });
    await commands.loadFabrics();
    fails = false;
    await commands.loadFabrics();
    expect(state.editing.ownFabrics.value).toHaveLength(1);
  });
});
