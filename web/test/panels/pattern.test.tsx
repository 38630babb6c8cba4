// @vitest-environment jsdom
import { fireEvent, screen, within } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { choose, click, openPage, type, type Page } from './page';
import { ApiError } from '../../src/api/http';
import type { Pieces, Seam } from '../../src/api/types';
import { FabricField } from '../../src/panels/FabricField';
import { FabricSwatch } from '../../src/panels/FabricSwatch';
import { HistoryList } from '../../src/panels/HistoryList';
import { PatternFiles } from '../../src/panels/PatternFiles';
import { PatternPanel } from '../../src/panels/PatternPanel';
import { ProposalList } from '../../src/panels/ProposalList';
import { UnsewnPieces } from '../../src/panels/UnsewnPieces';
import { SeamList } from '../../src/panels/SeamList';
import { SelectionPanel } from '../../src/panels/SelectionPanel';
import { TextureFields } from '../../src/panels/TextureFields';
import { ready } from '../../src/state/AppState';
import { points } from '../../src/tools/points';
import { assetOf, seamOf, squareOf } from '../fakes';
import { fabricOf } from '../samples';

const side = seamOf('side', ['a', 'e1'], ['b', 'e3'], { length_a_mm: 100, length_b_mm: 98 });
const two = (seams: Seam[] = [side]): Pieces => ({
  pieces: [squareOf('a', 0, 0, 100), squareOf('b', 200, 0, 50)],
  seams,
});
const button = (name: string | RegExp): HTMLElement => screen.getByRole('button', { name });
const field = (name: string): HTMLElement => screen.getByRole('textbox', { name });

let page: Page;
beforeEach(() => {
  page = openPage();
});

/** Draws the panel of these pieces. */
function open(pieces: Pieces): void {
  page.change((state) => (state.pieces.value = ready(pieces)));
  page.show(<PatternPanel />);
  page.asked();
}

describe('the pattern to take home', () => {
  const urls = {
    patternPdfUrl: (project: string, paper: string): string => `/projects/${project}/pattern.pdf?paper=${paper}`,
    patternSvgUrl: (project: string): string => `/projects/${project}/pattern.svg`,
    patternDxfUrl: (project: string): string => `/projects/${project}/pattern.dxf`,
  };
  const links = (): (string | null)[] => screen.getAllByRole('link').map((link) => link.getAttribute('href'));

  it('is offered as pages, as a sheet and as DXF, under the name of the project', () => {
    page.show(<PatternFiles urls={urls} />);
    expect(links()).toEqual([
      '/projects/p_1/pattern.pdf?paper=a4',
      '/projects/p_1/pattern.svg',
      '/projects/p_1/pattern.dxf',
    ]);
    const name = page.state.project.value!.name;
    expect(screen.getAllByRole('link').map((link) => link.getAttribute('download'))).toEqual([
      `${name}.pdf`,
      `${name}.svg`,
      `${name}.dxf`,
    ]);
  });

  it('has its pages of the paper that is chosen', () => {
    page.show(<PatternFiles urls={urls} />);
    choose(screen.getByRole('combobox', { name: 'Paper of the PDF' }), 'letter');
    expect(links()[0]).toBe('/projects/p_1/pattern.pdf?paper=letter');
    expect(links()[1]).toBe('/projects/p_1/pattern.svg');
  });

  it('stands beside the pattern', () => {
    page.change((state) => (state.pieces.value = ready(two())));
    page.show(<PatternPanel files={urls} />);
    expect(screen.getByRole('region', { name: 'Take out the pattern' })).toBeTruthy();
  });
});

describe('beside the pattern', () => {
  it('stands what will be there, while there is none', () => {
    page.show(<PatternPanel />);
    expect(screen.getByText('The pattern of the project is edited here.')).toBeTruthy();
  });

  it('stand the selection, the seams and the proposals', () => {
    open(two());
    expect(screen.getByText(/Select a piece to rename/)).toBeTruthy();
    expect(screen.getByRole('region', { name: 'Seams' })).toBeTruthy();
    expect(screen.getByRole('region', { name: 'Proposed seams' })).toBeTruthy();
    expect(screen.queryByRole('region', { name: 'New seam' })).toBeNull();
  });

  it('stands the panel of the tool that is held', () => {
    open(two());
    page.change((state) => (state.editing.tool.value = 'sew'));
    expect(screen.getByRole('region', { name: 'New seam' })).toBeTruthy();
  });
});

describe('a selected piece', () => {
  beforeEach(() => {
    page.change((state) => (state.selected.value = 'a'));
    page.show(<SelectionPanel pieces={two()} />);
    page.asked();
  });

  it('is told in figures', () => {
    expect(screen.getByText(/100.0 × 100.0 mm · 4 edges/)).toBeTruthy();
    expect((field('Name of the piece') as HTMLInputElement).value).toBe('a');
  });

  it('is renamed by typing over its name', () => {
    type(field('Name of the piece'), 'front');
    expect(page.asked()).toEqual([['pattern.renamePiece', 'a', 'front']]);
  });

  it('keeps its name when nothing is typed', () => {
    type(field('Name of the piece'), '  ');
    expect(page.asked()).toEqual([]);
    expect((field('Name of the piece') as HTMLInputElement).value).toBe('a');
  });

  it('is moved and turned by numbers', () => {
    type(field('x mm'), '12,5');
    type(field('Grain °'), '45');
    expect(page.asked()).toEqual([
      ['pattern.movePiece', 'a', [12.5, 0]],
      ['edits.send', { edit: 'rotate_grain', piece: 'a', angle: -45 }],
    ]);
  });

  it('has a button for each thing that is done with a whole piece', () => {
    for (const name of ['Grain +45°', 'Mirror', 'Duplicate', 'Mirrored copy', 'Delete']) click(button(name));
    expect(page.asked()).toEqual([
      ['edits.send', { edit: 'rotate_grain', piece: 'a', angle: 45 }],
      ['edits.send', { edit: 'mirror_piece', piece: 'a' }],
      ['pattern.duplicatePiece', 'a', false],
      ['pattern.duplicatePiece', 'a', true],
      ['pattern.removePiece', 'a'],
    ]);
  });

  it('has its edges as buttons, which take the points tool', () => {
    click(within(screen.getByRole('list', { name: 'Edges of a' })).getByRole('button', { name: /top/ }));
    expect(page.asked()).toEqual([
      ['pattern.takeTool', points],
      ['pattern.selectPart', { kind: 'edge', piece: 'a', edge: 'e2' }],
    ]);
  });

  it('gets a dart within its cloth, as wide and long as is said', () => {
    fireEvent.click(screen.getByText('Dart within the piece'));
    type(field('Width mm'), '12');
    type(field('Length mm'), '60');
    click(button('Add dart'));
    expect(page.asked()).toEqual([['pattern.addInnerDart', 'a', [50, 20], [50, 80], 12]]);
  });
});

describe('a selected edge', () => {
  beforeEach(() => {
    page.change((state) => (state.editing.part.value = { kind: 'edge', piece: 'a', edge: 'e1' }));
    page.show(<SelectionPanel pieces={two()} />);
    page.asked();
  });

  it('gets a length, and keeps the end that is chosen', () => {
    choose(screen.getByRole('combobox', { name: 'Keep' }), 'end');
    type(field('Length mm'), '120');
    expect(page.asked()).toEqual([
      ['edits.send', { edit: 'set_edge_length', piece: 'a', edge: 'e1', length_mm: 120, keep: 'end' }],
    ]);
  });

  it('has a button for each thing that is done with an edge', () => {
    for (const name of ['Make a curve', 'Insert point', 'Split in the middle', 'Join with top']) click(button(name));
    expect(page.asked()).toEqual([
      ['pattern.bendOrStraighten', 'a', 'e1'],
      ['edits.send', { edit: 'insert_point', piece: 'a', edge: 'e1', at: 0.5 }],
      ['edits.send', { edit: 'split_edge', piece: 'a', edge: 'e1', at: 0.5 }],
      ['pattern.joinWithNext', 'a', 'e1'],
    ]);
    expect(screen.queryByRole('button', { name: 'Whole edge' })).toBeNull();
  });

  it('is renamed, gets a dart, and leads to the seam that it is sewn in', () => {
    type(field('Name of the edge'), 'hem');
    fireEvent.click(screen.getByText('Dart in the middle'));
    click(button('Add dart'));
    click(button('1 side'));
    expect(page.asked()).toEqual([
      ['pattern.renameEdge', 'a', 'e1', 'hem'],
      ['pattern.addDart', 'a', 'e1', 30, 100],
      ['pattern.selectSeam', 'side'],
    ]);
  });
});

describe('a selected point', () => {
  const corner = { kind: 'point', piece: 'a', edge: 'e1', point: 0 } as const;

  it('is moved by numbers and deleted', () => {
    page.change((state) => (state.editing.part.value = corner));
    page.show(<SelectionPanel pieces={two()} />);
    expect(screen.getByRole('heading', { name: 'Corner · right' })).toBeTruthy();
    page.asked();
    type(field('x mm'), '110');
    click(button('Delete point'));
    click(button('Whole edge'));
    expect(page.asked()).toEqual([
      ['edits.send', { edit: 'move_point', piece: 'a', edge: 'e1', point: 0, to: [110, 0] }],
      ['pattern.remove'],
      ['pattern.selectPart', { kind: 'edge', piece: 'a', edge: 'e1' }],
    ]);
  });

  it('gets a notch, or loses the one that marks it', () => {
    const pieces = two();
    page.change((state) => (state.editing.part.value = corner));
    page.show(<SelectionPanel pieces={pieces} />);
    page.asked();
    click(button('Notch'));
    pieces.pieces[0] = { ...pieces.pieces[0]!, notches: [{ at: [100, 0], depth_mm: 5, inwards: null }] };
    page.show(<SelectionPanel pieces={{ ...pieces }} />);
    click(button('Remove notch'));
    expect(page.asked()).toEqual([
      ['edits.send', { edit: 'add_notch', piece: 'a', edge: 'e1', at: 0, depth_mm: 5 }],
      ['edits.send', { edit: 'remove_notch', piece: 'a', notch: 0 }],
    ]);
  });

  it('that is a handle is moved as one', () => {
    const handle = { kind: 'handle', piece: 'a', edge: 'e0', curve: 0, handle: 2 } as const;
    page.change((state) => (state.editing.part.value = handle));
    page.show(<SelectionPanel pieces={two()} />);
    page.asked();
    type(field('y mm'), '-20');
    expect(screen.getByRole('heading', { name: 'Handle · bottom' })).toBeTruthy();
    expect(page.asked()[0]![1]).toMatchObject({ edit: 'move_handle', curve: 0, handle: 2 });
    expect(button('Make straight')).toBeTruthy();
  });
});

describe('the list of seams', () => {
  it('says that there is none', () => {
    page.show(<SeamList pieces={two([])} />);
    expect(screen.getByText('Nothing is sewn yet.')).toBeTruthy();
  });

  it('tells lengths and warnings, lights what is pointed at and selects what is clicked', () => {
    const issue = { code: 'seam.lengths', error: false, message: 'one side is longer', where: '' };
    page.show(<SeamList pieces={two([{ ...side, issues: [issue] }])} />);
    expect(screen.getByText('1 warning')).toBeTruthy();
    const row = button(/1 side/);
    expect(row.textContent).toContain('100.0 ⇄ 98.0 mm');
    fireEvent.focus(row);
    click(row);
    expect(page.asked()).toEqual([
      ['pattern.lightSeam', 'side'],
      ['pattern.selectSeam', 'side'],
    ]);
  });

  it('leaves no seam lit when its row goes away under the pointer', () => {
    page.show(<SeamList pieces={two()} />);
    page.change((state) => (state.editing.litSeam.value = 'side'));
    page.show(null);
    expect(page.asked()).toEqual([['pattern.lightSeam', null]]);
  });

  it('opens the one that is selected', () => {
    page.change((state) => (state.editing.seam.value = 'side'));
    page.show(<SeamList pieces={two()} />);
    expect(screen.getByText(/2\.0 mm \(2\.0 %\)/)).toBeTruthy();
    expect(screen.queryByRole('button', { name: 'Remove dart' })).toBeNull();
    click(button('Reverse'));
    click(button('Remove seam'));
    click(button(/1 side/));
    expect(page.asked()).toEqual([
      ['edits.send', { edit: 'reverse_seam', seam: 'side' }],
      ['edits.send', { edit: 'remove_seam', seam: 'side' }],
      ['pattern.selectSeam', null],
      ['pattern.selectSeam', null],
    ]);
  });

  it('takes a dart away as a whole', () => {
    page.change((state) => (state.editing.seam.value = 'dart1'));
    page.show(<SeamList pieces={two([seamOf('dart1', ['a', 'dart1_a'], ['a', 'dart1_b'])])} />);
    click(button('Remove dart'));
    expect(page.asked()).toEqual([['edits.send', { edit: 'remove_dart', seam: 'dart1' }]]);
  });
});

describe('pieces that no seam holds', () => {
  it('are chosen one at a time, lit under the pointer, and let go again', () => {
    const said: (string | null)[] = [];
    const show = (chosen: string | null): void =>
      page.show(<UnsewnPieces pieces={['a', 'b']} chosen={chosen} choose={(piece) => said.push(piece)} light={(piece) => said.push(piece)} />);
    show(null);
    fireEvent.pointerEnter(button('b'));
    fireEvent.pointerLeave(button('b'));
    click(button('b'));
    show('b');
    expect(button('b').getAttribute('aria-pressed')).toBe('true');
    click(button('b'));
    expect(said).toEqual(['b', null, 'b', null]);
    page.show(<UnsewnPieces pieces={[]} chosen={null} choose={() => undefined} light={() => undefined} />);
    expect(screen.queryByRole('button')).toBeNull();
  });
});

describe('the proposals', () => {
  const found = { ...seamOf('seam0', ['a', 'e0'], ['b', 'e2']), confidence: 0.93, to_wear: true, length_a_mm: 10, length_b_mm: 10 };

  it('are looked for when somebody asks', () => {
    page.show(<ProposalList pieces={two()} />);
    click(button('Look for seams'));
    expect(page.asked()).toEqual([['seams.propose']]);
    page.change((state) => (state.editing.proposals.value = { state: 'loading' }));
    expect(screen.getByRole('status').textContent).toContain('Looking at lengths');
  });

  it('say why there are none', () => {
    page.change(
      (state) =>
        (state.editing.proposals.value = { state: 'failed', error: new ApiError(500, 'x', 'the search ended early') }),
    );
    page.show(<ProposalList pieces={two()} />);
    expect(screen.getByText('The search ended early.')).toBeTruthy();
    page.change((state) => (state.editing.proposals.value = ready([])));
    expect(screen.getByText('No further seams are found.')).toBeTruthy();
  });

  it('are ticked one by one and sewn together', () => {
    page.change((state) => {
      state.editing.proposals.value = ready([found]);
      state.editing.chosen.value = new Set(['seam0']);
    });
    page.show(<ProposalList pieces={two()} />);
    expect(screen.getByTitle('Confidence').textContent).toBe('93 %');
    click(screen.getByRole('checkbox'));
    click(button('Sew 1 seam'));
    expect(page.asked()).toEqual([['seams.choose', 'seam0', false], ['seams.acceptProposals']]);
    page.change((state) => (state.editing.chosen.value = new Set()));
    expect(button('Sew 0 seams').hasAttribute('disabled')).toBe(true);
  });

  it('are lit where they are pointed at, and sewn one by one', () => {
    page.change((state) => (state.editing.proposals.value = ready([found, { ...found, id: 'seam1', confidence: 0.4, to_wear: false }])));
    page.show(<ProposalList pieces={two()} />);
    const unsure = within(screen.getByRole('list', { name: 'Unsure proposals' }));
    fireEvent.pointerEnter(unsure.getByRole('listitem'));
    click(unsure.getByRole('button', { name: /^Sew a · / }));
    expect(page.asked()).toMatchObject([['seams.lightProposal', { id: 'seam1' }], ['seams.acceptProposal', 'seam1']]);
  });

  it('of a piece stand alone while it is selected; pieces that nothing holds are told', () => {
    page.change((state) => (state.editing.proposals.value = ready([found])));
    const pieces = [...two().pieces, squareOf('c', 0, 0, 10)];
    page.show(<ProposalList pieces={{ pieces, seams: [seamOf('s', ['a', 'e1'], ['b', 'e3'])] }} />);
    expect(screen.getByText(/^1 piece is sewn to nothing/)).toBeTruthy();
    click(button('c'));
    expect(page.asked()).toContainEqual(['select', 'c']);
    page.change((state) => (state.selected.value = 'c'));
    expect(screen.getByText(/^Nothing is proposed for c/)).toBeTruthy();
    page.change((state) => (state.selected.value = 'b'));
    expect(screen.getAllByRole('listitem')).toHaveLength(1);
    click(button('Show all 1'));
    expect(page.asked()).toContainEqual(['select', null]);
  });

  it('are not asked for where there are no pieces', () => {
    page.show(<ProposalList pieces={{ pieces: [], seams: [] }} />);
    expect(screen.queryByRole('region')).toBeNull();
  });
});

describe('the history', () => {
  it('says what was done, newest first, and what was undone', () => {
    page.show(<HistoryList />);
    expect(screen.queryByText('History')).toBeNull();
    page.change((state) => {
      state.now.value = 100_000;
      state.editing.history.value = [
        { number: 2, undone: true, created_ms: 99_000, edits: [{ edit: 'remove_seam', seam: 's' }] },
        { number: 1, undone: false, created_ms: 98_000, edits: [{ edit: 'mirror_piece', piece: 'a' }] },
      ];
    });
    expect(screen.getAllByRole('listitem', { hidden: true }).map((row) => row.textContent)).toEqual([
      'Remove seam, sundone',
      'Mirror piece, ajust now',
    ]);
  });
});

describe('the fabric of pieces', () => {
  const library = [fabricOf('denim-10oz', { areal_mass_g_m2: 339 }), fabricOf('twill'), fabricOf('jersey', { construction: 'knit' })];
  const cards = (): (string | null)[] =>
    [...document.querySelectorAll('.fabric-library li b')].map((one) => one.textContent);

  const edits = () => page.asked().filter(([command]) => command === 'edits.send');

  it('is chosen out of the library’s cards, for one piece or for all', () => {
    page.change((state) => (state.editing.fabrics.value = library));
    page.show(<FabricField pieces={two().pieces} />);
    expect(page.asked()).toEqual([['pattern.loadFabrics']]);
    click(button('Change'));
    expect(cards()).toEqual(['Title of jersey', 'Title of twill', 'Title of denim-10oz']);
    click(button(/Title of twill/));
    expect(edits()).toEqual([
      ['edits.send', ...two().pieces.map(({ id }) => ({ edit: 'set_fabric', piece: id, fabric: 'twill' }))],
    ]);
    expect(cards()).toEqual([]);
  });

  it('is found by words and by its kind', () => {
    page.change((state) => (state.editing.fabrics.value = library));
    page.show(<FabricField pieces={two().pieces} />);
    click(button('Change'));
    click(screen.getByRole('radio', { name: 'Knit' }));
    expect(cards()).toEqual(['Title of jersey']);
    fireEvent.input(screen.getByLabelText('Find a fabric'), { target: { value: 'velvet' } });
    expect(screen.getByText('No fabric is called so.')).toBeTruthy();
  });

  it('says that pieces differ, and of a known one what it weighs and how it bends', () => {
    page.change((state) => (state.editing.fabrics.value = library));
    const [a, b] = two().pieces.map((piece, i) => ({ ...piece, fabric: i === 0 ? 'twill' : 'my own' }));
    page.show(<FabricField pieces={[a!, b!]} />);
    expect(screen.getByText('pieces differ')).toBeTruthy();
    expect(screen.getByText('Title of twill, my own')).toBeTruthy();
    page.show(<FabricField pieces={[a!]} />);
    expect(screen.getByText(/^240 g\/m² · cotton, 2\/1 twill/)).toBeTruthy();
    expect(screen.getByText('Bending length').nextSibling!.textContent).toBe('26 / 25 mm');
  });

  it('of the document’s own is called as the library calls what it is like, with that one’s card', () => {
    page.change((state) => {
      state.editing.fabrics.value = library;
      state.editing.ownFabrics.value = [{ id: 'main', name: '', like: 'twill', differs: false }];
    });
    page.show(<FabricField pieces={two().pieces.map((piece) => ({ ...piece, fabric: 'main' }))} />);
    expect(document.querySelector('.fabric-card b')!.textContent).toBe('Title of twill');
    page.change((state) => (state.editing.ownFabrics.value = [{ id: 'main', name: '', like: 'twill', differs: true }]));
    expect(document.querySelector('.fabric-own')!.textContent).toBe('Title of twill, changed');
  });

  it('is seen as a snippet in its colour, with light threads on dark cloth', () => {
    const threads = (colour: [number, number, number]): string | null => {
      page.show(<FabricSwatch fabric={fabricOf('twill', { colour })} />);
      return document.querySelector('.swatch pattern path')!.getAttribute('stroke');
    };
    expect(threads([0.02, 0.02, 0.05])).toBe('#ffffff');
    expect(threads([0.9, 0.9, 0.9])).toBe('#000000');
    expect(document.querySelector<SVGElement>('.swatch rect')!.getAttribute('fill')).toMatch(/^rgb\(2/);
  });

  it('that it has already is no change', () => {
    page.change((state) => (state.editing.fabrics.value = library));
    page.show(<FabricField pieces={two().pieces.map((piece) => ({ ...piece, fabric: 'twill' }))} />);
    click(button('Change'));
    click(screen.getAllByRole('button', { name: /Title of twill/ }).at(-1)!);
    expect(edits()).toEqual([]);
  });
});

describe('the picture on a piece', () => {
  const texture = { image: 'check.png', scale_mm: 80, offset: [5, 6] as [number, number], angle: 0 };
  const printed = two().pieces.map((piece) => ({ ...piece, texture: piece.id === 'a' ? texture : null }));

  it('is chosen of those that were uploaded before', () => {
    page.change(
      (state) => (state.editing.images.value = [assetOf({ id: 'a_7', kind: 'image', name: 'check.png' })]),
    );
    page.show(<TextureFields pieces={[two().pieces[0]!]} all={two().pieces} />);
    expect(page.asked()).toEqual([['textures.loadImages']]);
    choose(screen.getByRole('combobox', { name: 'Picture' }), 'a_7');
    expect(page.asked()).toMatchObject([['textures.putOn', ['a'], { id: 'a_7' }]]);
    expect(screen.queryByRole('button', { name: 'Take off' })).toBeNull();
  });

  it('is uploaded', () => {
    page.show(<TextureFields pieces={[two().pieces[0]!]} all={two().pieces} />);
    page.asked();
    const file = new File(['x'], 'check.png');
    fireEvent.change(screen.getByLabelText('Picture file'), { target: { files: [file] } });
    expect(page.asked()).toEqual([['textures.upload', ['a'], 'check.png', file]]);
    page.change((state) => (state.editing.uploading.value = true));
    expect(button('Uploading…').hasAttribute('disabled')).toBe(true);
  });

  it('is laid by numbers, put on all pieces and taken off', () => {
    page.show(<TextureFields pieces={[printed[0]!]} all={printed} />);
    page.asked();
    type(field('Repeat mm'), '120');
    type(field('Repeat mm'), '-5');
    type(field('Offset x mm'), '0');
    click(button('Same on all pieces'));
    click(button('Take off'));
    expect(page.asked()).toEqual([
      ['textures.lay', ['a'], { scale_mm: 120 }],
      ['textures.lay', ['a'], { offset: [0, 6] }],
      ['textures.onAll', texture],
      ['textures.takeOff', ['a']],
    ]);
  });

  it('may differ from piece to piece', () => {
    page.show(<TextureFields pieces={printed} all={printed} />);
    expect(screen.getByText('pieces differ')).toBeTruthy();
    expect(screen.queryByRole('textbox')).toBeNull();
  });
});
