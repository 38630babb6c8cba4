// @vitest-environment jsdom
import { fireEvent, screen, within } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { choose, click, openPage, type Page } from './page';
import { ApiError } from '../../src/api/http';
import { ImportLayers } from '../../src/panels/ImportLayers';
import { ImportPanel } from '../../src/panels/ImportPanel';
import { ImportReport } from '../../src/panels/ImportReport';
import { ImportSeams } from '../../src/panels/ImportSeams';
import { IntakeDialog } from '../../src/panels/IntakeDialog';
import { ImportPreview } from '../../src/pattern/ImportPreview';
import { ready, type Intake } from '../../src/state/AppState';
import type { ImportDraft, PreviewProps } from '../../src/state/importDraft';
import { planIntake, type GivenFile } from '../../src/state/intake';
import { speak, speakCodes } from '../../src/texts/language';
import type { Import } from '../../src/api/types';
import { assetOf } from '../fakes';
import { importedPiece, importOf, layerOf, meshFormats } from '../samples';

const button = (name: string | RegExp): HTMLElement => screen.getByRole('button', { name });
const isOff = (thing: HTMLElement): boolean => thing.hasAttribute('disabled');
const fileOf = (name: string, text = 'x'): GivenFile => ({ name, blob: new Blob([text]) });
const Preview = ({ lit }: PreviewProps) => <p>lit: {lit ?? 'none'}</p>;

const draftOf = (more: Partial<ImportDraft> = {}): ImportDraft => ({
  source: { kind: 'dxf', file: fileOf('shirt.dxf'), bodies: [] },
  asset: 'a_1',
  report: ready(importOf()),
  unit: '',
  size: '',
  layers: {},
  fileLayers: [],
  rereading: false,
  left: new Set(['torn']),
  chosen: new Set(['seam0']),
  body: { kind: 'mannequin', preset: '' },
  bodyTaken: false,
  name: 'shirt',
  bodies: [],
  presets: [],
  error: null,
  ...more,
});
const intakeOf = (more: Partial<Intake> = {}): Intake => ({ files: [], plan: null, busy: '', error: null, ...more });

let page: Page;
beforeEach(() => {
  page = openPage();
});

describe('the dialog of a new project', () => {
  const open = (intake: Intake | null, draft: ImportDraft | null = null): void => {
    page.change((state) => {
      state.intake.value = intake;
      state.importing.value = draft;
    });
    page.show(<IntakeDialog Preview={Preview} />);
  };

  it('is away until files are given', () => {
    open(null);
    expect(screen.queryByRole('dialog')).toBeNull();
  });

  it('is left by a second Escape only, once there is something to lose', () => {
    open(intakeOf(), draftOf());
    const dialog = screen.getByRole('dialog');
    expect(fireEvent(dialog, new Event('cancel', { cancelable: true }))).toBe(false);
    expect(screen.getByText(/Escape once more/)).toBeTruthy();
    expect(page.asked()).toEqual([]);
    fireEvent(dialog, new Event('cancel', { cancelable: true }));
    expect(page.asked()).toEqual([['intake.close']]);
  });

  it('asks for files, and makes nothing of none', () => {
    open(intakeOf());
    expect(screen.getByRole('dialog', { name: 'New project' })).toBeTruthy();
    expect(button(/Drop files here/)).toBeTruthy();
    expect([isOff(button('Create')), isOff(button('Create and drape'))]).toEqual([true, true]);
    const input = document.querySelector('input')!;
    const file = new File(['x'], 'body.3ds');
    fireEvent.change(input, { target: { files: [file] } });
    click(button('Close'));
    expect(page.asked()).toEqual([['intake.addFiles', [{ name: 'body.3ds', blob: file }]], ['intake.close']]);
  });

  it('takes every mesh that the service reads', () => {
    open(intakeOf());
    expect(document.querySelector('input')!.accept).toBe('');
    page.change((state) => (state.dressing.tables.value = { presets: [], measures: [], formats: meshFormats }));
    const accepted = document.querySelector('input')!.accept.split(',');
    expect(accepted).toEqual(expect.arrayContaining(['.json', '.dxf', '.obj', '.3ds', '.off', '.png']));
  });

  it('says what a project still needs', async () => {
    const document = JSON.stringify({ toile: 1, name: 'Skirt', pieces: [], bodies: [{ file: 'body.obj' }] });
    const files = [fileOf('project.json', document), fileOf('spare.dxf')];
    open(intakeOf({ files, plan: await planIntake(files, null) }));
    expect(screen.getByText(/also needs this file/).textContent).toBe('Skirt also needs this file:');
    expect(screen.getByText('body.obj').parentElement!.textContent).toBe('body.obj the body');
    const rows = screen.getAllByRole('listitem').map((row) => row.querySelector('small')?.textContent);
    expect(rows.slice(0, 2)).toEqual(['Project', 'Not used']);
    click(button('Remove spare.dxf'));
    expect(page.asked()).toEqual([['intake.removeFile', 'spare.dxf']]);
    expect(isOff(button('Create'))).toBe(true);
  });

  it('makes the project once everything is there', async () => {
    const files = [fileOf('project.json', JSON.stringify({ toile: 1, pieces: [] }))];
    open(intakeOf({ files, plan: await planIntake(files, null) }));
    expect(screen.getByText('Everything is there.')).toBeTruthy();
    click(button('Create'));
    click(button('Create and drape'));
    expect(page.asked()).toEqual([
      ['intake.createProject', false],
      ['intake.createProject', true],
    ]);
  });

  it('says which file is of no use, and why something was refused', async () => {
    const files = [fileOf('letter.doc')];
    const plan = await planIntake(files, ['.obj']);
    const error = new ApiError(422, 'dxf.truncated', 'the file ends early', 'line 3');
    open(intakeOf({ files, plan, error }));
    const [kind, refused] = screen.getAllByRole('alert').map((one) => one.textContent);
    expect(kind).toMatch(/^Neither a project .*file\.kind · letter\.doc$/);
    expect(refused).toBe('The file ends early.dxf.truncated · line 3');
  });

  it('waits while it does something', () => {
    open(intakeOf({ files: [fileOf('shirt.dxf')], busy: 'Uploading shirt.dxf' }), draftOf());
    expect(screen.getByText('Uploading shirt.dxf…')).toBeTruthy();
    expect(isOff(button('Create and drape'))).toBe(true);
  });

  it('makes a project of a pattern by itself', () => {
    open(intakeOf({ files: [fileOf('shirt.dxf')] }), draftOf());
    expect(screen.getByRole('dialog', { name: 'New project from shirt.dxf' })).toBeTruthy();
    click(button('Create and drape'));
    expect(page.asked()).toEqual([['imports.make', true]]);
    page.change((state) => (state.importing.value = draftOf({ left: new Set(['front', 'sleeve', 'torn']) })));
    expect(isOff(button('Create'))).toBe(true);
  });
});

describe('a pattern file', () => {
  const open = (draft: ImportDraft): void => {
    page.change((state) => (state.intake.value = intakeOf()));
    page.show(<ImportPanel draft={draft} Preview={Preview} />);
  };

  it('is read, or says why it cannot be', () => {
    open(draftOf({ report: { state: 'loading' } }));
    expect(screen.getByRole('status').textContent).toContain('Reading shirt.dxf');
    const error = new ApiError(422, 'dxf.size', 'there is no such size', 'size 52');
    open(draftOf({ report: { state: 'failed', error }, size: '52' }));
    expect(screen.getByRole('alert').textContent).toContain('There is no such size.');
    click(button('Read it as the file says'));
    expect(page.asked()).toEqual([['imports.takeUnit', '']]);
  });

  it('shows its pieces with what was done to them, to be left out', () => {
    open(draftOf());
    const rows = within(screen.getByRole('list', { name: 'Pieces' })).getAllByRole('listitem');
    expect(rows.map((row) => row.querySelector('small')!.textContent)).toEqual(['', '2 ×, 1 mirrored', '']);
    const boxes = screen.getAllByRole('checkbox');
    expect(isOff(boxes[2]!)).toBe(true);
    click(boxes[1]!);
    expect(page.asked()).toEqual([['imports.takePiece', 'sleeve', false]]);
  });

  it('is told its unit and size', () => {
    open(draftOf());
    expect(screen.getByText('sure, 90 %')).toBeTruthy();
    expect(screen.getByText('The size of the pieces.')).toBeTruthy();
    click(screen.getByRole('radio', { name: 'inch' }));
    choose(screen.getByRole('combobox', { name: 'Size' }), '40');
    open(draftOf({ unit: 'inch' }));
    click(button('back to the guess'));
    expect(page.asked()).toEqual([
      ['imports.takeUnit', 'inch'],
      ['imports.takeSize', '40'],
      ['imports.takeUnit', ''],
    ]);
  });

  it('in a unit that makes giants of its pieces says so where the unit is chosen, with the way back', () => {
    const doubt = { own: 'mm', largest_mm: 14948.8, largest_own_mm: 588.5 };
    const unit = { name: 'inch', mm_per_unit: 25.4, confidence: 1, evidence: ['asked for'], doubt };
    open(draftOf({ unit: 'inch', report: ready(importOf({ unit })) }));
    const words = screen.getByRole('alert').textContent;
    expect(words).toContain('The largest piece would measure 14,949 mm.');
    expect(words).toContain('it is in mm, and that piece measures 589 mm.');
    click(button('Take mm'));
    expect(page.asked()).toEqual([['imports.takeUnit', 'mm']]);
    open(draftOf({ unit: 'mm' }));
    expect(screen.queryByRole('alert')).toBeNull();
  });

  it('that says its unit itself is believed', () => {
    open(draftOf({ source: { kind: 'specification', file: fileOf('apron.json'), bodies: [] } }));
    expect(screen.getAllByRole('radio').every(isOff)).toBe(true);
  });

  it('gets a name and a body', () => {
    const mesh = fileOf('anna.obj');
    const bodies = [assetOf({ id: 'a_9', name: 'scan.obj' })];
    open(
      draftOf({
        bodies,
        presets: [{ id: 'eu38' }],
        source: { ...draftOf().source, bodies: [mesh] },
      }),
    );
    fireEvent.input(screen.getByRole('textbox', { name: 'Name' }), { target: { value: 'Blouse' } });
    const body = screen.getByRole('combobox', { name: 'Body' });
    for (const value of ['mannequin eu38', 'asset a_9', 'file']) choose(body, value);
    expect(page.asked()).toEqual([
      ['imports.takeName', 'Blouse'],
      ['imports.takeBody', { kind: 'mannequin', preset: 'eu38' }],
      ['imports.takeBody', { kind: 'asset', id: 'a_9', name: 'scan.obj' }],
      ['imports.takeBody', { kind: 'file', file: mesh }],
    ]);
  });

  it('lights the seam in the preview that is pointed at in the list', () => {
    open(draftOf());
    click(screen.getByRole('tab', { name: 'Seams 1 of 2' }));
    fireEvent.focus(screen.getAllByRole('checkbox')[0]!);
    expect(screen.getByText('lit: seam0')).toBeTruthy();
    fireEvent.keyDown(screen.getByRole('tablist'), { key: 'ArrowRight' });
    expect(screen.getByRole('tab', { selected: true }).textContent).toBe('Report, 1 warning');
    expect(screen.getByRole('region', { name: 'Import report' })).toBeTruthy();
  });
});

describe('the layers of a file', () => {
  const rows = (): string[] => screen.getAllByRole<HTMLSelectElement>('combobox').map((one) => one.selectedOptions[0]!.text);

  it('tell what stands on them and what they are read as, and are told otherwise', () => {
    page.show(<ImportLayers draft={draftOf()} layers={importOf().layers} />);
    expect(rows()).toEqual(['as usual: cut line', 'as usual: texts', 'as usual: unknown, lines within']);
    expect(screen.getByText('2 TEXT')).toBeTruthy();
    choose(screen.getByRole('combobox', { name: 'Layer A is' }), 'sew');
    choose(screen.getByRole('combobox', { name: 'Layer 15 is' }), 'ignore');
    expect(page.asked()).toEqual([
      ['imports.takeLayer', 'A', 'sew'],
      ['imports.takeLayer', '15', 'ignore'],
    ]);
    expect(screen.queryByRole('button', { name: 'Read all as usual' })).toBeNull();
  });

  it('are shown as told, and read as usual again at once', () => {
    const draft = draftOf({ layers: { A: 'sew' } });
    page.show(<ImportLayers draft={draft} layers={[layerOf('1', 'cut'), layerOf('A', 'sew', { given: true })]} />);
    expect(rows()).toEqual(['as usual: cut line', 'sew line']);
    choose(screen.getByRole('combobox', { name: 'Layer A is' }), '');
    click(button('Read all as usual'));
    expect(page.asked()).toEqual([['imports.takeLayer', 'A', ''], ['imports.takeNoLayers']]);
  });

  it('have a page of their own in the import, which stays while the file is read again', () => {
    page.change((state) => (state.intake.value = intakeOf()));
    page.show(<ImportPanel draft={draftOf()} Preview={Preview} />);
    click(screen.getByRole('tab', { name: 'Layers 3' }));
    expect(screen.getByRole('region', { name: 'Layers of the file' })).toBeTruthy();
    page.show(<ImportPanel draft={draftOf({ layers: { A: 'sew' }, rereading: true })} Preview={Preview} />);
    expect(screen.getByRole('region', { name: 'Layers of the file' }).getAttribute('aria-busy')).toBe('true');
    page.show(<ImportPanel draft={draftOf({ report: ready(importOf({ layers: [] })) })} Preview={Preview} />);
    expect(screen.queryByRole('tab', { name: /Layers/ })).toBeNull();
  });

  it('can be told where nothing could be made of the file; their page stays once something can', () => {
    const error = new ApiError(422, 'dxf.no_outline', 'the drawing holds no closed outline', '');
    const failed = draftOf({ report: { state: 'failed', error }, fileLayers: importOf().layers });
    page.change((state) => (state.intake.value = intakeOf()));
    page.show(<ImportPanel draft={failed} Preview={Preview} />);
    expect(screen.getByRole('alert').textContent).toContain('The drawing holds no closed outline.');
    expect(screen.getByText(/Say below which one is the cut line/)).toBeTruthy();
    choose(screen.getByRole('combobox', { name: 'Layer A is' }), 'cut');
    expect(page.asked()).toEqual([['imports.takeLayer', 'A', 'cut']]);
    page.show(<ImportPanel draft={draftOf({ layers: { A: 'cut' } })} Preview={Preview} />);
    expect(screen.getByRole('tab', { name: 'Layers 3', selected: true })).toBeTruthy();
  });
});

describe('the seams that a file proposes', () => {
  it('are ticked one by one, or by how sure they are', () => {
    page.show(<ImportSeams draft={draftOf()} report={importOf()} onLight={() => undefined} onPiece={() => undefined} />);
    const [first, second] = screen.getAllByRole<HTMLInputElement>('checkbox');
    expect([first!.checked, second!.checked]).toEqual([true, false]);
    click(second!);
    for (const name of ['The sure ones', 'All', 'None']) click(button(name));
    expect(page.asked()).toEqual([
      ['imports.takeSeam', 'seam1', true],
      ['imports.takeSurest', 0.8],
      ['imports.takeSurest', 0],
      ['imports.takeSurest', 2],
    ]);
  });

  it('are unsure where a garment is not begun with them; a piece that nothing holds shows what is proposed for it', () => {
    const pointed: (string | null)[] = [];
    page.show(<ImportSeams draft={draftOf()} report={importOf()} onLight={() => undefined} onPiece={(piece) => pointed.push(piece)} />);
    expect(within(screen.getByRole('list', { name: 'Unsure proposals' })).getAllByRole('checkbox')).toHaveLength(1);
    expect(screen.getByText(/^1 piece is sewn to nothing/)).toBeTruthy();
    const loose = button('sleeve_mirrored');
    fireEvent.pointerEnter(loose);
    expect(pointed).toEqual(['sleeve']);
    click(loose);
    expect(screen.getByText(/^Proposed for sleeve_mirrored/)).toBeTruthy();
    expect(screen.getAllByRole('checkbox')).toHaveLength(1);
    click(button('Show all 2'));
    expect(screen.getAllByRole('checkbox')).toHaveLength(2);
  });

  it('are none where none could be found', () => {
    page.show(<ImportSeams draft={draftOf()} report={importOf({ seams: [] })} onLight={() => undefined} onPiece={() => undefined} />);
    expect(screen.getByText(/none could be found/)).toBeTruthy();
  });
});

describe('the report of a file', () => {
  const kinds = (): (string | undefined)[] =>
    within(screen.getByRole('list', { name: 'Entities' }))
      .queryAllByRole('listitem')
      .map((row) => row.querySelector('b')?.textContent ?? undefined);

  it('accounts for every entity', () => {
    page.show(<ImportReport report={importOf()} />);
    expect(screen.getByText('Every one is accounted for.')).toBeTruthy();
    expect(kinds()).toEqual(['3 × POLYLINE', '2 × TEXT', 'IMAGE']);
    const warning = within(screen.getByRole('list', { name: 'Warnings' })).getByRole('listitem');
    expect(warning.textContent).toBe('A gap was closed.piece front · at 1, 2 mm · line 9 · 2 times');
  });

  it('shows one fate, one piece or what a word is in', () => {
    page.show(<ImportReport report={importOf()} />);
    click(screen.getByRole('radio', { name: '1 dropped' }));
    expect(kinds()).toEqual(['IMAGE']);
    click(screen.getByRole('radio', { name: '6 all' }));
    choose(screen.getByRole('combobox', { name: 'Piece' }), 'front');
    expect(kinds()).toEqual(['3 × POLYLINE']);
    fireEvent.input(screen.getByRole('searchbox'), { target: { value: 'nothing of the sort' } });
    expect(screen.getByText('Nothing of that kind.')).toBeTruthy();
  });

  it('is read in German, kinds and reasons', async () => {
    await speak('de');
    await speakCodes();
    const entities = [{ type: 'panel', layer: '', block: '', fate: 'kept', reason: 'outline', piece: '', count: 2, lines: [] }, { type: 'LINE', layer: '7', block: '', fate: 'kept', reason: 'a new word', piece: '', count: 1, lines: [] }] as Import['report']['entities'];
    page.show(<ImportReport report={importOf({ report: { ...importOf().report, entities } })} />);
    const rows = within(screen.getByRole('list', { name: 'Elemente' })).getAllByRole('listitem');
    expect(rows.map((row) => row.querySelector('b')!.textContent)).toEqual(['2 × Schnittteil', 'LINE']);
    expect(rows[0]!.querySelectorAll('p')[1]!.textContent).toBe('Umriss.');
    expect(rows[1]!.querySelector('[lang=en]')!.textContent).toBe('A new word.');
    await speak('en');
  });

  it('is saved', () => {
    page.show(<ImportReport report={importOf()} />);
    click(button('Save as JSON'));
    expect(page.asked()).toEqual([['imports.saveReport']]);
  });
});

describe('the preview of a file', () => {
  it('draws its pieces, both of a pair; a click leaves one with its other half out or takes it in again', () => {
    page.show(<ImportPreview draft={draftOf()} report={importOf()} lit={null} onLight={() => undefined} piece={null} onPiece={() => undefined} />);
    const preview = screen.getByRole('group', { name: 'Preview of 4 pieces' });
    fireEvent.click(within(preview).getByRole('button', { name: /Piece front/ }));
    fireEvent.click(within(preview).getByRole('button', { name: /Piece sleeve_mirrored/ }));
    fireEvent.click(within(preview).getByRole('button', { name: /Piece torn/ }));
    expect(page.asked()).toEqual([
      ['imports.takePiece', 'front', false],
      ['imports.takePiece', 'sleeve', false],
      ['imports.takePiece', 'torn', true],
    ]);
  });

  it('tells the piece that is pointed at in the list, both halves of a pair, and the other way about', () => {
    page.show(<ImportPanel draft={draftOf()} Preview={ImportPreview} />);
    const row = (name: string): Element => screen.getByRole('checkbox', { name: new RegExp(`^${name}`) }).closest('li')!;
    const lit = (): (string | null)[] => [...document.querySelectorAll('.piece.hovered')].map((piece) => piece.getAttribute('data-piece'));
    expect(lit()).toEqual([]);
    fireEvent.pointerEnter(row('sleeve'));
    expect(lit()).toEqual(['sleeve', 'sleeve_mirrored']);
    fireEvent.pointerLeave(row('sleeve'));
    expect(lit()).toEqual([]);
    fireEvent.pointerEnter(document.querySelector('[data-piece=front]')!);
    expect(row('front').classList).toContain('lit');
    expect(row('sleeve').classList).not.toContain('lit');
  });

  it('says that nothing can be cut', () => {
    const report = importOf({ pieces: [importedPiece('torn', { points: [] })] });
    page.show(<ImportPreview draft={draftOf()} report={report} lit={null} onLight={() => undefined} piece={null} onPiece={() => undefined} />);
    expect(screen.getByText('No piece of this file can be cut.')).toBeTruthy();
  });
});
