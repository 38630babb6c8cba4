import { describe, expect, it } from 'vitest';
import type { Api } from '../src/api/Api';
import { ApiError } from '../src/api/http';
import { ImportCommands } from '../src/commands/ImportCommands';
import { AppState, valueOf } from '../src/state/AppState';
import {
  accountsOf,
  documentOf,
  entitiesShown,
  linesText,
  namesPattern,
  pictureOf,
  piecesDrawn,
  presetNamed,
  projectNameOf,
  seamsInReach,
  sourceNames,
  sureness,
  warningsShown,
} from '../src/state/importDraft';
import type { LoosePattern } from '../src/state/intake';
import { fakeApi, projectOf } from './fakes';
import { importedPiece, importOf } from './samples';

const source = (): LoosePattern => ({ kind: 'dxf', file: { name: 'shirt.dxf', blob: new Blob(['x']) }, bodies: [] });

function begin(more: Partial<Api> = {}) {
  const state = new AppState();
  const made: string[] = [];
  const api = fakeApi({ importPattern: async () => importOf(), ...more });
  const imports = new ImportCommands(
    state,
    api,
    async (project, drape) => void made.push(`${project.id} ${project.revision} ${drape}`),
    (name) => void made.push(name),
  );
  state.intake.value = { files: [], plan: null, busy: '', error: null };
  return { state, imports, made };
}

describe('a project of a file', () => {
  it('is called by the file, without the ending that all specifications have', () => {
    expect(['skirt.dxf', 'hoody_specification.json', '_specification.json'].map(projectNameOf)).toEqual(['skirt', 'hoody', '_specification']);
  });
});

describe('a pattern that was dropped', () => {
  it('is uploaded and read; sure seams are ticked and torn pieces left out', async () => {
    const { state, imports } = begin();
    await imports.follow(source());
    const draft = state.importing.value!;
    expect(valueOf(draft.report)?.file).toBe('shirt.dxf');
    expect([...draft.chosen]).toEqual(['seam0']);
    expect([...draft.left]).toEqual(['torn']);
    expect(draft.name).toBe('shirt');
  });

  it('is read again in the unit and size that a person says', async () => {
    const asked: string[] = [];
    const { imports } = begin({
      importPattern: async (asset, unit, size) => {
        asked.push(`${asset} ${unit} ${size}`);
        return importOf();
      },
    });
    await imports.follow(source());
    await imports.takeUnit('inch');
    await imports.takeSize('40');
    expect(asked).toEqual(['a_shirt.dxf  ', 'a_shirt.dxf inch ', 'a_shirt.dxf inch 40']);
  });

  it('is read again with the layers that a person says, and as usual once they are taken back', async () => {
    const asked: unknown[] = [];
    const { imports, state } = begin({
      importPattern: async (_asset, _unit, _size, layers) => {
        asked.push(layers);
        return importOf();
      },
    });
    await imports.follow(source());
    await imports.takeLayer('3', 'sew');
    await imports.takeLayer('5', 'cut');
    await imports.takeLayer('3', '');
    await imports.takeNoLayers();
    expect(asked).toEqual([{}, { '3': 'sew' }, { '3': 'sew', '5': 'cut' }, { '5': 'cut' }, {}]);
    expect(state.importing.value!.rereading).toBe(false);
  });

  it('shows what it was until it is read again, and is made no project of meanwhile', async () => {
    const answers: (() => void)[] = [];
    const { imports, state } = begin({
      importPattern: (_asset, _unit, _size, layers) =>
        Object.keys(layers).length === 0
          ? Promise.resolve(importOf())
          : new Promise((done) => answers.push(() => done(importOf({ style: JSON.stringify(layers) })))),
    });
    await imports.follow(source());
    const first = imports.takeLayer('3', 'sew');
    const second = imports.takeLayer('3', 'cut');
    expect(state.importing.value).toMatchObject({ rereading: true, report: { state: 'ready' } });
    answers[0]!();
    await first;
    expect(valueOf(state.importing.value!.report)?.style).toBe(''); // it was asked otherwise in the meantime
    answers[1]!();
    await second;
    expect(valueOf(state.importing.value!.report)?.style).toBe('{"3":"cut"}');
    expect(state.importing.value!.rereading).toBe(false);
  });

  it('that holds no piece as usual shows its layers, and is read once they are told', async () => {
    const { imports, state } = begin({
      importPattern: (_asset, _unit, _size, layers) =>
        layers['5'] === 'cut' ? Promise.resolve(importOf()) : Promise.reject(new ApiError(422, 'dxf.no_outline', 'none')),
      layers: async () => importOf().layers,
    });
    await imports.follow(source());
    expect(state.importing.value!.report.state).toBe('failed');
    expect(state.importing.value!.fileLayers.map(({ name }) => name)).toEqual(['1', '15', 'A']);
    await imports.takeLayer('5', 'cut');
    expect(state.importing.value!.report.state).toBe('ready');
  });

  it('becomes a project with its file, seams and body, and is arranged', async () => {
    const sent: { document: Record<string, unknown>; files: Record<string, string> }[] = [];
    const { imports, made, state } = begin({
      createProject: async (document, files) => {
        sent.push({ document: document as Record<string, unknown>, files });
        return projectOf({ id: 'p_new' });
      },
    });
    await imports.follow(source());
    imports.takeName('Shirt of mine');
    imports.takeBody({ kind: 'asset', id: 'a_b', name: 'body.obj' });
    await imports.make(true);
    expect(sent[0]!.files).toEqual({ 'shirt.dxf': 'a_1', 'body.obj': 'a_b' });
    expect(sent[0]!.document).toMatchObject({
      name: 'Shirt of mine',
      bodies: [{ file: 'body.obj' }],
      seams: [{ id: 'seam0' }],
    });
    expect(made).toEqual(['p_new 2 true']);
    expect(state.importing.value).toBeNull();
  });

  it('is a project also when its pieces cannot be arranged', async () => {
    const { imports, made } = begin({ arrange: () => Promise.reject(new ApiError(422, 'arrange.no_seams', 'none')) });
    await imports.follow(source());
    await imports.make(false);
    expect(made).toEqual(['p_new 1 false']);
  });

  it('that cannot be read says so', async () => {
    const { imports, state } = begin({
      uploadAsset: () => Promise.reject(new ApiError(422, 'dxf.truncated', 'It ends early.', 'shirt.dxf: line 3')),
    });
    await imports.follow(source());
    expect(state.importing.value?.report).toMatchObject({ state: 'failed', error: { code: 'dxf.truncated' } });
  });
});

describe('the body of an import', () => {
  const presets = ['eu34', 'eu38', 'm46', 'm50'].map((id) => ({ id }));
  const none = { sizes: [], size: '', sample_size: '' };

  it('is of the size that the file names', () => {
    const named = (file: string, more = {}): string => presetNamed(importOf({ file, ...none, ...more }), presets);
    expect(named('skirt-cisFemaleAdult34.dxf')).toBe('eu34');
    expect(named('Rock EU38.dxf')).toBe('eu38');
    expect(named('mens_jacket.dxf', { size: '46' })).toBe('m46');
    expect(named('block-cisMaleAdult38.dxf', { size: 'M' })).toBe('m50');
    expect(named('blouse.dxf', { size: 'M' })).toBe('eu38');
    expect(named('drawing 1234.dxf')).toBe('');
  });

  it('stays the one that a person chose', async () => {
    const { state, imports } = begin({ bodyPresets: async () => presets });
    await imports.follow(source());
    expect(state.importing.value!.body).toEqual({ kind: 'mannequin', preset: 'eu38' });
    imports.takeBody({ kind: 'mannequin', preset: '' });
    await imports.takeUnit('inch');
    expect(state.importing.value!.body).toEqual({ kind: 'mannequin', preset: '' });
  });
});

describe('the pieces of an import', () => {
  it('are drawn both of a pair, the other half turned over with its edges running the other way', () => {
    const report = importOf();
    report.pieces[1] = importedPiece('sleeve', {
      quantity: 2,
      mirrored: 1,
      edge_list: [
        { id: 'e0', length_mm: 100, points: [[0, 0], [100, 0]], start: [0, 0], end: [100, 0], curves: 1 },
        { id: 'e1', length_mm: 50, points: [[0, 50], [0, 0]], start: [0, 50], end: [0, 0], curves: 1 },
      ],
    });
    const drawn = piecesDrawn(report);
    expect(drawn.map(({ id }) => id)).toEqual(['front', 'sleeve', 'sleeve_mirrored', 'torn']);
    const other = drawn[2]!;
    expect(other.outline).toEqual([[-0, 50], [-100, 0], [-0, 0]]);
    expect(other.edges.map(({ id, points }) => [id, points])).toEqual([
      ['e1', [[-0, 0], [-0, 50]]],
      ['e0', [[-100, 0], [-0, 0]]],
    ]);
  });
});

describe('the document of an import', () => {
  const draft = () => {
    const { state, imports } = begin();
    return imports.follow(source()).then(() => state.importing.value!);
  };

  it('leaves out pieces with all their copies, and the seams that need them', async () => {
    const made = documentOf({ ...(await draft()), left: new Set(['sleeve']) }, importOf(), null)!;
    expect((made.pieces as { id: string }[]).map((one) => one.id)).toEqual(['front']);
    expect(made.seams).toEqual([]);
    expect([...sourceNames(importOf())]).toContainEqual(['sleeve_mirrored', 'sleeve']);
    expect(seamsInReach(importOf(), new Set(['torn'])).length).toBe(2);
  });

  it('has the mannequin of a size table, or of usual measures', async () => {
    const sized = documentOf({ ...(await draft()), body: { kind: 'mannequin', preset: 'eu38' } }, importOf(), null)!;
    expect(sized.bodies).toEqual([{ id: 'body', mannequin: { preset: 'eu38' } }]);
    expect(documentOf(await draft(), importOf(), null)!.bodies).toEqual([{ id: 'body', mannequin: {} }]);
  });

  it('is none without a piece', async () => {
    expect(documentOf({ ...(await draft()), left: new Set(['front', 'sleeve']) }, importOf(), null)).toBeNull();
    expect(documentOf(await draft(), importOf({ document: null }), null)).toBeNull();
    expect(namesPattern({ pieces: [{ id: 'a' }] })).toBe(false);
  });
});

describe('the import report', () => {
  it('adds up to the file, and says when it does not', () => {
    const accounts = accountsOf(importOf().report);
    expect(accounts.whole).toBe(true);
    expect(accounts.sum).toBe('20 records: 6 entities, 9 vertices, 4 of structure, 1 in tables and objects');
    expect(accounts.shares.map((share) => share.count)).toEqual([3, 2, 1]);
    const short = { ...importOf().report, counts: { ...importOf().report.counts, records: 21 } };
    expect(accountsOf(short).whole).toBe(false);
    expect(accountsOf({ counts: { panels: 2, edges: 8 }, entities: [], warnings: [] }).sum).toBe('2 panels, 8 edges');
  });

  it('can be filtered by what became of things, by piece and by words', () => {
    const { entities, warnings } = importOf().report;
    const filter = { fate: '', piece: '', text: '' } as const;
    expect(entitiesShown(entities, { ...filter, fate: 'dropped' }).map((one) => one.type)).toEqual(['IMAGE']);
    expect(entitiesShown(entities, { ...filter, piece: 'front' }).length).toBe(1);
    expect(entitiesShown(entities, { ...filter, text: 'NAME' }).map((one) => one.type)).toEqual(['TEXT']);
    expect(warningsShown(warnings, { ...filter, piece: 'sleeve' })).toEqual([]);
    expect(warningsShown(warnings, { ...filter, text: 'gap' }).length).toBe(1);
  });

  it('names lines, not all of many', () => {
    expect(linesText([12])).toBe('line 12');
    expect(linesText([1, 2, 3, 4, 5, 6])).toBe('lines 1, 2, 3, 4 and 2 more');
    expect(linesText([0])).toBe('');
    expect([0.95, 0.7, 0.3].map(sureness)).toEqual(['sure', 'likely', 'a guess']);
  });

  it('draws a piece with its grain and notches', () => {
    const drawn = pictureOf(importedPiece('x', { grain_deg: 0, notch_list: [{ at: [1, 1], depth_mm: 4, angle_deg: 90 }] }));
    expect(drawn.grain![0]).toBeCloseTo(1, 9);
    expect(drawn.notches[0]!.inwards![1]).toBeCloseTo(1, 9);
    expect(pictureOf(importedPiece('y', { grain_deg: null })).grain).toBeNull();
  });
});
