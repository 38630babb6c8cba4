// @vitest-environment jsdom
import { fireEvent, screen, within } from '@testing-library/dom';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { click, openPage, type, type Page } from './page';
import { ApiError } from '../../src/api/http';
import type { Seam } from '../../src/api/types';
import { HelpDialog } from '../../src/panels/HelpDialog';
import { PatternPanel } from '../../src/panels/PatternPanel';
import { PatternPane } from '../../src/pattern/PatternPane';
import { ready, valueOf } from '../../src/state/AppState';
import { emptyDraft } from '../../src/state/seamView';
import { listenForKeys } from '../../src/tools/keys';
import type { PatternTool } from '../../src/tools/PatternTool';
import { pieces } from '../../src/tools/pieces';
import { points } from '../../src/tools/points';
import { SeamDraftPanel } from '../../src/tools/SeamDraftPanel';
import { range } from '../../src/tools/range';
import { sew } from '../../src/tools/sew';
import { projectOf, seamOf, squareOf } from '../fakes';

/** A tool that the page does not have: all that the page knows of it is its line in the table. */
const knife = vi.hoisted(
  (): PatternTool => ({
    id: 'knife',
    keepsPart: false,
    words: () => ({ title: 'Knife', hint: 'Cut an edge in two', help: 'Cut edges' }),
    key: 'K',
    cursor: { paper: 'cell' },
    clickPiece: () => undefined,
    edges: {
      tabbed: 'all',
      press: ({ commands }, { piece, edge }) =>
        void commands.edits.send({ edit: 'split_edge', piece, edge, at: 0.5 }),
    },
    say: () => 'Click where to cut',
    Panel: ({ pieces: all }) => <p>{all.pieces.length} pieces to cut</p>,
  }),
);

vi.mock('../../src/tools/table', async (original) => {
  const table = await original<typeof import('../../src/tools/table')>();
  const patternTools = [...table.patternTools, knife];
  return { ...table, patternTools, toolOf: (id: string) => patternTools.find((tool) => tool.id === id)! };
});

const side = seamOf('side', ['a', 'e1'], ['b', 'e3'], { length_a_mm: 100, length_b_mm: 100 });
const button = (name: string | RegExp): HTMLElement => screen.getByRole('button', { name });
const note = (): string | undefined => document.querySelector('.pattern-note')?.textContent ?? undefined;

let page: Page;
beforeEach(() => {
  page = openPage();
});

/** The 2D view of two squares, with this tool held. */
function open(tool: PatternTool = pieces, seams: Seam[] = [side]): void {
  page.change((state) => {
    state.editing.tool.value = tool.id;
    state.pieces.value = ready({ pieces: [squareOf('a', 0, 0, 100), squareOf('b', 200, 0, 100)], seams });
  });
  page.show(<PatternPane />);
}

/** The scale of the view, pixels a millimetre. */
const scale = (): number => {
  const [, , width] = screen.getByRole('group').getAttribute('viewBox')!.split(' ').map(Number);
  return 400 / width!;
};

/** Presses at a place of the page and drags by millimetres, y up; what is shown meanwhile is looked at by `meanwhile`. */
function drag(from: Element, [x, y]: [number, number], keys = {}, meanwhile: () => void = () => undefined): void {
  const plane = screen.getByRole('group');
  const to = { clientX: 100 + x * scale(), clientY: 100 - y * scale(), buttons: 1, ...keys };
  fireEvent.pointerDown(from, { clientX: 100, clientY: 100, button: 0, buttons: 1 });
  fireEvent.pointerMove(plane, to);
  meanwhile();
  fireEvent.pointerUp(plane, { ...to, buttons: 0 });
}

const press = (thing: Element): void => {
  fireEvent.pointerDown(thing, { clientX: 100, clientY: 100, button: 0, buttons: 1 });
  fireEvent.pointerUp(screen.getByRole('group'), { clientX: 101, clientY: 100, button: 0 });
};

describe('the 2D view', () => {
  it('says that it waits, and why there is nothing', () => {
    page.show(<PatternPane />);
    expect(screen.getByText('The flat pieces of the garment appear here.')).toBeTruthy();
    page.change((state) => (state.pieces.value = { state: 'loading' }));
    expect(screen.getByRole('status', { name: 'Loading the pattern' })).toBeTruthy();
    const error = new ApiError(422, 'dxf.truncated', 'the file ends early', 'line 3');
    page.change((state) => (state.pieces.value = { state: 'failed', error }));
    expect(screen.getByRole('alert').textContent).toContain('The file ends early.dxf.truncated · line 3');
  });

  it('tells name and size of a piece that is pointed at or selected where they do not stand on it', () => {
    page.change((state) => {
      const small = squareOf('under_collar', 300, 0, 4);
      state.pieces.value = ready({ pieces: [squareOf('a', 0, 0, 100), squareOf('b', 150, 0, 4), small], seams: [] });
    });
    page.show(<PatternPane />);
    const tags = (): string[] => [...document.querySelectorAll('.piece-tag')].map((tag) => tag.textContent);
    page.change((state) => (state.hovered.value = 'a'));
    expect(tags()).toEqual([]);
    page.change((state) => (state.hovered.value = 'b'));
    expect(tags()).toEqual(['b 4 × 4 mm']);
    page.change((state) => (state.selected.value = 'under_collar'));
    expect(tags()).toEqual(['b 4 × 4 mm', 'under_collar 4 × 4 mm']);
    const twin = squareOf('twin_collar', 306, 0, 4);
    page.change((state) => {
      const { pieces: all, seams } = valueOf(state.pieces.value!)!;
      state.pieces.value = ready({ pieces: [...all, twin], seams });
      state.hovered.value = 'twin_collar';
    });
    const heights = [...document.querySelectorAll('.piece-tag')].map((tag) => /translate\(\S+ (\S+)\)/.exec(tag.getAttribute('transform')!)![1]);
    expect(new Set(heights).size).toBe(2);
  });

  it('lights a seam that is proposed, between both pieces, and tells it below', () => {
    open();
    const proposal = { ...seamOf('seam9', ['a', 'e0'], ['b', 'e2']), confidence: 0.4, to_wear: false, length_a_mm: 100, length_b_mm: 100 };
    page.change((state) => (state.editing.litProposal.value = proposal));
    expect(document.querySelectorAll('.seam.lit[data-seam=seam9]')).toHaveLength(2);
    expect(document.querySelector('.threads')).toBeTruthy();
    expect(note()).toMatch(/^a · .+ to b · .+100\.0 ⇄ 100\.0 mm/);
    page.change((state) => (state.editing.litProposal.value = null));
    expect(document.querySelector('[data-seam=seam9]')).toBeNull();
  });

  it('has a button for each tool, and for what was done last', () => {
    open();
    const tools = within(screen.getByRole('toolbar', { name: 'Pattern tools' }));
    expect(tools.getByRole('button', { name: 'Pieces' }).getAttribute('aria-pressed')).toBe('true');
    expect(tools.getByRole('button', { name: 'Sew' }).title).toBe('Click edges together (N)');
    expect(tools.getByRole('button', { name: 'Undo' }).hasAttribute('disabled')).toBe(true);
    page.change(
      (state) =>
        (state.editing.history.value = [
          { number: 2, undone: true, created_ms: 0, edits: [{ edit: 'mirror_piece', piece: 'b' }] },
          { number: 1, undone: false, created_ms: 0, edits: [{ edit: 'mirror_piece', piece: 'a' }] },
        ]),
    );
    for (const name of ['Points', 'Undo Mirror piece, a', 'Redo Mirror piece, b', 'Large pattern']) click(button(name));
    expect(page.asked()).toEqual([['pattern.takeTool', points], ['edits.undo'], ['edits.redo']]);
    expect(page.state.editing.large.value).toBe(true);
  });

  it('is panned with the hand, zoomed and fitted', () => {
    open();
    const plane = screen.getByRole('group');
    const at = (): number[] => plane.getAttribute('viewBox')!.split(' ').map(Number);
    const first = at();
    drag(plane, [-50, 0]);
    expect(at()[0]! - first[0]!).toBeCloseTo(50, 6);
    click(button('Zoom in'));
    expect(at()[2]! / first[2]!).toBeCloseTo(0.8, 6);
    click(button('Fit'));
    expect(at()).toEqual(first);
    expect(page.asked()).toEqual([]);
  });

  it('selects nothing when the paper is clicked', () => {
    open();
    press(screen.getByRole('group'));
    expect(page.asked()).toEqual([
      ['pattern.selectPart', null],
      ['select', null],
    ]);
  });

  it('tells what was refused before anything else', () => {
    open(sew);
    page.change((state) => (state.editing.problem.value = new ApiError(422, 'x', 'it crosses itself', 'piece a')));
    expect(screen.getByRole('alert').textContent).toBe('It crosses itself.x · piece a');
  });

  it('tells both lengths of the seam that is lit', () => {
    open();
    page.change((state) => (state.editing.litSeam.value = 'side'));
    expect(note()).toBe('1 side 100.0 ⇄ 100.0 mm · equal');
    expect(document.querySelector('.threads')).not.toBeNull();
  });
});

describe('the tool for pieces', () => {
  it('selects a piece, and lets go of it', () => {
    open();
    press(button(/Piece a/));
    page.change((state) => (state.selected.value = 'a'));
    fireEvent.keyDown(button(/Piece a/), { key: 'Enter' });
    expect(page.asked().filter(([command]) => command === 'select')).toEqual([
      ['select', 'a'],
      ['select', null],
    ]);
  });

  it('moves a piece, with Shift along one axis, and shows it there meanwhile', () => {
    open();
    const a = button(/Piece a/);
    const before = a.parentElement!.getAttribute('transform');
    drag(a, [30, 20], { shiftKey: true }, () => expect(a.parentElement!.getAttribute('transform')).toMatch(/^translate\((30|29\.9{9}\d*) 0\)$/));
    expect(before).toBe('translate(0 0)');
    const [[command, piece, by]] = page.asked() as [[string, string, number[]]];
    expect([command, piece]).toEqual(['pattern.movePiece', 'a']);
    expect(by[0]).toBeCloseTo(30, 9);
    expect(by[1]).toBe(0);
  });

  it('puts the piece back when the service changed nothing', async () => {
    open();
    const a = button(/Piece a/);
    drag(a, [30, 20]);
    await vi.waitFor(() => expect(a.parentElement!.getAttribute('transform')).toBe('translate(0 0)'));
  });

  it('selects seams', () => {
    open();
    fireEvent.pointerDown(document.querySelector('[data-seam=side]')!, { button: 0 });
    expect(page.asked()).toEqual([['pattern.selectSeam', 'side']]);
    expect(screen.queryByRole('button', { name: /^Edge/ })).toBeNull();
  });
});

describe('the tool for points', () => {
  const corner = (): HTMLElement => button(/Corner at the start of edge “top” at/);

  it('asks for a piece first', () => {
    open(points);
    expect(note()).toBe('Click a piece to see its points');
    press(button(/Piece b/));
    expect(page.asked()).toEqual([
      ['pattern.selectPart', null],
      ['select', 'b'],
    ]);
  });

  it('drags a corner, which jumps to the height of another', () => {
    open(points);
    page.change((state) => (state.selected.value = 'a'));
    drag(corner(), [40, -99.5], {}, () => {
      expect(note()).toBe('140.0, 0.0 mm');
      expect(document.querySelectorAll('.guides path').length).toBe(1);
    });
    expect(page.asked()).toEqual([
      ['pattern.selectPart', { kind: 'point', piece: 'a', edge: 'e2', point: 0 }],
      ['edits.send', { edit: 'move_point', piece: 'a', edge: 'e2', point: 0, to: [140, 0] }],
    ]);
  });

  it('drags it freely with Alt, and in steps of 45° with Shift', () => {
    open(points);
    page.change((state) => (state.selected.value = 'a'));
    drag(corner(), [40, -99.5], { altKey: true }, () => expect(note()).toBe('140.0, 0.5 mm'));
    expect(page.asked()[1]![1]).toMatchObject({ to: [140, 0.5] });
    page.change((state) => (state.pieces.value = ready({ pieces: [squareOf('a', 0, 0, 100)], seams: [] })));
    drag(corner(), [40, 38], { shiftKey: true }, () => expect(note()).toBe('139.0, 139.0 mm'));
  });

  it('drags handles', () => {
    open(points);
    page.change((state) => {
      state.selected.value = 'a';
      state.editing.part.value = { kind: 'edge', piece: 'a', edge: 'e0' };
    });
    drag(button(/Handle 1 of curve 1 of edge “bottom”/), [0, -20], { altKey: true });
    expect(page.asked()[1]![1]).toMatchObject({ edit: 'move_handle', edge: 'e0', curve: 0, handle: 1, to: [33.33, -20] });
  });

  it('moves a point by keys: those that follow each other are one edit', async () => {
    vi.useFakeTimers();
    open(points);
    page.change((state) => (state.selected.value = 'a'));
    fireEvent.keyDown(corner(), { key: 'ArrowRight' });
    fireEvent.keyDown(corner(), { key: 'ArrowUp', shiftKey: true });
    await vi.runAllTimersAsync();
    vi.useRealTimers();
    expect(page.asked().filter(([command]) => command === 'edits.send')).toEqual([
      ['edits.send', { edit: 'move_point', piece: 'a', edge: 'e2', point: 0, to: [101, 110] }],
    ]);
  });

  it('selects edges, and puts a point where one is clicked twice', () => {
    open(points);
    const edge = button(/Edge of a: right/);
    fireEvent.pointerDown(edge, { button: 0 });
    fireEvent.dblClick(edge);
    expect(page.asked()).toMatchObject([
      ['pattern.selectPart', { kind: 'edge', piece: 'a', edge: 'e1' }],
      ['edits.send', { edit: 'insert_point', piece: 'a', edge: 'e1' }],
    ]);
  });

  it('lights the seam of the edge that is pointed at', () => {
    open(points);
    fireEvent.pointerEnter(button(/Edge of a: right/));
    fireEvent.pointerLeave(button(/Edge of a: right/));
    expect(page.asked()).toEqual([
      ['pattern.lightSeam', 'side'],
      ['pattern.lightSeam', null],
    ]);
  });
});

describe('the tool for seams', () => {
  it('says what to click, side by side', () => {
    open(sew);
    expect(note()).toBe('Click the edges of one side, then press Enter');
    page.change((state) => (state.editing.draft.value = { ...emptyDraft, a: [{ piece: 'a', edge: 'e0' }], side: 'b' }));
    expect(note()).toBe('Click the edges of the other side, then press Enter');
  });

  it('takes edges by pointer and by key; Enter on one that is taken goes on', () => {
    open(sew);
    fireEvent.pointerDown(button(/Edge of a: bottom/), { button: 0 });
    fireEvent.keyDown(button(/Edge of b: bottom/), { key: ' ' });
    page.change((state) => (state.editing.draft.value = { ...emptyDraft, a: [{ piece: 'a', edge: 'e0' }] }));
    fireEvent.keyDown(button(/Edge of a: bottom/), { key: 'Enter' });
    expect(page.asked()).toEqual([
      ['seams.sewEdge', 'a', 'e0'],
      ['seams.sewEdge', 'b', 'e0'],
      ['seams.finishSide'],
    ]);
  });

  it('leaves pieces where they are: a drag moves the view', () => {
    open(sew);
    const before = screen.getByRole('group').getAttribute('viewBox');
    drag(button(/Piece a/), [30, 0]);
    expect(page.asked()).toEqual([]);
    expect(screen.getByRole('group').getAttribute('viewBox')).not.toBe(before);
  });

  it('has a panel with both sides, and the part of each edge', () => {
    page.change(
      (state) =>
        (state.editing.draft.value = {
          a: [{ piece: 'a', edge: 'e1' }],
          b: [{ piece: 'b', edge: 'e3' }],
          side: 'a',
          sameDirection: false,
        }),
    );
    page.show(<SeamDraftPanel pieces={{ pieces: [squareOf('a', 0, 0, 100), squareOf('b', 0, 0, 80)], seams: [] }} />);
    expect(button(/^A/).textContent).toBe('Aa · right100.0 mm');
    expect(screen.getByText(/100\.0 ⇄ 80\.0 mm/)).toBeTruthy();
    type(screen.getByRole('textbox', { name: 'to mm' }), '50');
    for (const name of ['Leave out a · right', 'Sew', 'Reverse', 'Clear']) click(button(name));
    expect(page.asked()).toEqual([
      ['seams.cutDraft', 'a', 0, 0, 0.5],
      ['seams.leaveOut', 'a', 0],
      ['seams.addSeam'],
      ['seams.turnDraft'],
      ['seams.clearDraft'],
    ]);
    click(button(/^B/));
    expect(page.state.editing.draft.value.side).toBe('b');
    const pressed = (): string | null => button('Reverse').getAttribute('aria-pressed');
    expect(pressed()).toBe('false');
    // A range against its outline, as it is drawn on a piece that lies beside the other.
    const drawn = { b: [{ piece: 'b', edge: 'e3', reversed: true }], sameDirection: true };
    page.change(({ editing }) => (editing.draft.value = { ...editing.draft.value, ...drawn }));
    expect(pressed()).toBe('false');
    page.change(({ editing }) => (editing.draft.value = { ...editing.draft.value, sameDirection: false }));
    expect(pressed()).toBe('true');
  });

  it('sews nothing before both sides have an edge', () => {
    page.show(<SeamDraftPanel pieces={{ pieces: [], seams: [] }} />);
    expect(button('Sew').hasAttribute('disabled')).toBe(true);
    expect(screen.getAllByText('Click edges on the pieces').length).toBe(2);
  });
});

describe('the tool for ranges', () => {
  it('asks for what the pointer does on all of the plane, and for whole edges by keys', () => {
    open(range);
    expect(note()).toBe('Click where one side begins, and where it ends');
    const plane = screen.getByRole('group');
    fireEvent.pointerMove(plane, { clientX: 100, clientY: 100 });
    fireEvent.pointerDown(button(/Edge of a: right/), { clientX: 100, clientY: 100, button: 0, buttons: 1, shiftKey: true });
    expect(document.activeElement, 'keys that follow are the plane’s').toBe(plane);
    fireEvent.pointerMove(plane, { clientX: 140, clientY: 100, buttons: 1 });
    fireEvent.pointerUp(plane, { clientX: 140, clientY: 100, button: 0 });
    fireEvent.pointerLeave(plane);
    fireEvent.keyDown(button(/Edge of a: right/), { key: 'Enter' });
    const calls = page.asked();
    expect(calls.map(([name]) => name)).toEqual([
      'ranges.point',
      'ranges.press',
      'ranges.point',
      'ranges.release',
      'ranges.point',
      'seams.sewEdge',
    ]);
    expect(calls[1]![2]).toBe(true);
    const [pressed, moved] = [calls[1]![1], calls[2]![1]] as { at: [number, number]; reach: number }[];
    expect((moved!.at[0] - pressed!.at[0]) * scale()).toBeCloseTo(40, 6);
    expect(pressed!.reach * scale()).toBeCloseTo(7, 6);
    expect(calls[4]).toEqual(['ranges.point', null]);
  });

  it('shows how long the range is and what it has met, and what is next', () => {
    open(range, []);
    const start = { piece: 'a', loop: 0, position: 120, point: [100, 20] as [number, number], snap: null };
    page.change(({ editing }) => (editing.place.value = start));
    expect(note()).toBe('Click where one side begins, and where it ends · 20.0 | 80.0 mm');
    page.change(({ editing }) => {
      editing.place.value = { ...start, position: 200, point: [100, 100], snap: 'corner' };
      editing.range.value = { start, end: editing.place.value, way: 80 };
    });
    expect(document.querySelector('.range-chip')!.textContent).toBe('80.0 mm, corner');
    expect(note()).toMatch(/^Click where it ends/);
    expect(document.querySelectorAll('[data-seam=new] .seam-line').length).toBe(1);
    page.change(({ editing }) => {
      editing.range.value = null;
      editing.place.value = null;
      editing.draft.value = { ...emptyDraft, a: [{ piece: 'a', edge: 'e1', from: 0.2 }], side: 'b' };
    });
    expect(note()).toMatch(/^Click where the other side begins/);
    page.change(({ editing }) => (editing.draft.value = { ...editing.draft.value, b: [{ piece: 'b', edge: 'e3', to: 0.8 }] }));
    expect(note()).toBe('New seam 80.0 ⇄ 80.0 mm · equal · Enter sews');
    expect(button(/Edge of a: right/).getAttribute('aria-pressed')).toBe('false');
  });
});

describe('a tool that is added to the table', () => {
  it('has its button, its cursor and its word under the pattern', () => {
    open(knife);
    expect(button('Knife').title).toBe('Cut an edge in two (K)');
    const view = screen.getByRole('region', { name: 'Pattern' });
    expect(view.style.getPropertyValue('--on-paper')).toBe('cell');
    expect(note()).toBe('Click where to cut');
  });

  it('is asked what it makes of the pointer', () => {
    open(knife);
    fireEvent.pointerDown(button(/Edge of a: right/), { button: 0 });
    expect(page.asked()).toEqual([['edits.send', { edit: 'split_edge', piece: 'a', edge: 'e1', at: 0.5 }]]);
  });

  it('has its panel beside the pattern', () => {
    open(knife);
    page.show(<PatternPanel />);
    expect(screen.getByText('2 pieces to cut')).toBeTruthy();
  });

  it('has its key, and a line in the list of keys', () => {
    const stop = listenForKeys(page.commands, page.state);
    fireEvent.keyDown(document.body, { key: 'k' });
    stop();
    expect(page.asked()).toEqual([['pattern.takeTool', knife]]);
    page.change((state) => (state.helpShown.value = true));
    page.show(<HelpDialog />);
    expect(screen.getByText('Cut edges').parentElement!.textContent).toBe('KCut edges');
  });
});

describe('pieces that come anew', () => {
  it('stand where the service has them', () => {
    open(points);
    page.change((state) => (state.selected.value = 'a'));
    drag(button(/Corner at the start of edge “top” at/), [40, 30], { altKey: true });
    page.change((state) => {
      state.projects.value = ready([projectOf({ revision: 2 })]);
      state.pieces.value = ready({ pieces: [squareOf('a', 0, 0, 120)], seams: [] });
    });
    expect(button(/Corner at the start of edge “top” at 120\.0, 120\.0 mm/)).toBeTruthy();
    expect(note()).toBeUndefined();
  });
});
