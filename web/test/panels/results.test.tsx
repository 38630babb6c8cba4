// @vitest-environment jsdom
import { fireEvent, screen, within } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { click, openPage, type Page } from './page';
import { ApiError } from '../../src/api/http';
import type { Edit, Job, MovieOrder, Report, StillOrder, StillWish } from '../../src/api/types';
import { CompareWith } from '../../src/panels/CompareWith';
import { ComparisonPanel } from '../../src/panels/ComparisonPanel';
import { DrapeFigures } from '../../src/panels/DrapeFigures';
import { FitTable } from '../../src/panels/FitTable';
import { Movies } from '../../src/panels/Movies';
import { OutcomeList } from '../../src/panels/OutcomeList';
import { Pictures } from '../../src/panels/Pictures';
import { Results } from '../../src/panels/Results';
import { SeamChip } from '../../src/panels/SeamChip';
import { SolverField } from '../../src/panels/SolverField';
import { ready } from '../../src/state/AppState';
import type { Compared } from '../../src/state/comparison';
import { jobOf, projectOf, seamOf, squareOf } from '../fakes';
import { fabricOf, reportOf } from '../samples';

const resultUrl = (job: string, name: string): string => `/results/${job}/${name}`;

let page: Page;
beforeEach(() => {
  page = openPage();
});

const drape = (more: Partial<Job> = {}): void => page.change((state) => (state.jobs.value = ready([jobOf(more)])));

describe('the fit table', () => {
  const girth = (at: string, more: Partial<NonNullable<Report['fit']>[number]> = {}): NonNullable<Report['fit']>[number] => ({
    at,
    fit: 'fits',
    text: '',
    body_mm: 680,
    garment_mm: 722,
    ease_mm: 42,
    worn_mm: 725,
    tight_by_mm: 0,
    shifted_mm: 0,
    pieces: ['front'],
    place: [0, 1, 0],
    ...more,
  });
  const rows = (): string[][] =>
    [...document.querySelectorAll('.fit tbody tr')].map((row) => [...row.children].map((cell) => cell.textContent ?? ''));

  it('sets body and garment side by side, in the unit that is chosen', () => {
    const report = reportOf({ fit: [girth('waist'), girth('thigh_left', { ease_mm: -5 })] });
    page.show(<FitTable report={report} />);
    expect(rows()).toEqual([
      ['Waist', '68.0 cm', '72.2 cm', '+4.2 cm'],
      ['Thigh, left', '68.0 cm', '72.2 cm', '−0.5 cm'],
    ]);
    page.change((state) => (state.dressing.unit.value = 'inch'));
    expect(rows()[0]).toEqual(['Waist', '26.77 in', '28.43 in', '+1.65 in']);
  });

  it('names what is too tight, and where else it was measured', () => {
    const tight = girth('hip', { fit: 'too_tight', ease_mm: -21, tight_by_mm: 21, shifted_mm: 35 });
    page.show(<FitTable report={reportOf({ fit: [tight] })} />);
    expect(screen.getByText('2.1 cm too tight')).toBeTruthy();
    expect(screen.getByText('2.1 cm too tight').closest('tr')?.title).toMatch(/^Measured 3\.5 cm above/);
  });

  it('is not there where nothing goes around anybody', () => {
    page.show(<FitTable report={reportOf({ fit: [] })} />);
    expect(document.querySelector('.fit')).toBeNull();
  });
});

describe('a drape under way', () => {
  it('waits for its first speeds, then draws them', () => {
    drape();
    page.show(<DrapeFigures />);
    expect(screen.getByText(/speed of the cloth is drawn here/)).toBeTruthy();
    page.change(
      (state) =>
        (state.history.value = [
          { t: 0.5, speed: 1 },
          { t: 2, speed: 0.02 },
        ]),
    );
    expect(screen.getByRole('img', { name: 'Speed of the cloth, now 20.0 mm/s' })).toBeTruthy();
    expect(screen.getByText('2.0 s')).toBeTruthy();
  });

  it('is told in facts', () => {
    drape({ started_ms: 1000, ended_ms: 66_000, state: 'succeeded', project_revision: 7 });
    page.show(<DrapeFigures />);
    const facts = [...document.querySelectorAll('.facts div')].map((row) => row.textContent);
    expect(facts).toEqual(['Drapej_1', 'Project revision7', 'Running time1 min 5 s']);
  });

  it('is made by the solver that is chosen beside it', () => {
    page.change((state) => (state.pieces.value = ready({ pieces: [squareOf('front', 0, 0, 10)], seams: [] })));
    page.show(<SolverField />);
    const chooser = screen.getByRole<HTMLSelectElement>('combobox', { name: 'Solver' });
    expect(chooser.value).toBe('toile');
    fireEvent.change(chooser, { target: { value: 'paper' } });
    expect(page.asked()).toEqual([['edits.send', { edit: 'set_solver', solver: 'paper' }]]);
    page.change(
      (state) => (state.pieces.value = ready({ pieces: [squareOf('front', 0, 0, 10)], seams: [], solver: 'paper' })),
    );
    expect(screen.getByText(/may let cloth through; crossings are counted/)).toBeTruthy();
  });

  it('says why it failed, where, and offers the way out', () => {
    page.change((state) => (state.pieces.value = ready({ pieces: [squareOf('front', 0, 0, 10)], seams: [] })));
    const code = 'start.crosses_body';
    drape({ state: 'failed', reason_code: code, reason: 'it stands in the body', reason_where: 'piece front at (0, 1, 0) m' });
    page.show(<OutcomeList />);
    const said = within(screen.getByRole('alert'));
    expect(said.getByRole('heading').textContent).toBe('The drape failed');
    expect(said.getByText(/begins within the body/)).toBeTruthy();
    expect(said.getByText(code)).toBeTruthy();
    for (const name of ['front', 'Arrange anew and drape', 'Place it by hand']) click(said.getByRole('button', { name }));
    expect(page.asked()).toEqual([
      ['select', 'front'],
      ['mend', { kind: 'arrange' }],
      ['mend', { kind: 'place', piece: 'front' }],
    ]);
  });

  it('says what has been changed since, and drapes again', () => {
    drape({ state: 'succeeded', created_ms: 100 });
    page.show(<OutcomeList />);
    expect(screen.queryByText('Changed since this drape')).toBeNull();
    const step = (number: number, created_ms: number, edit: Edit) => ({ number, created_ms, undone: false, edits: [edit] });
    page.change((state) => {
      state.projects.value = ready([projectOf({ revision: 3 })]);
      state.editing.history.value = [
        step(2, 200, { edit: 'set_texture', piece: 'front' }),
        step(1, 50, { edit: 'mirror_piece', piece: 'front' }),
      ];
    });
    expect(screen.getByText(/^Since then: Change picture, front\. Cloth, figures and files/)).toBeTruthy();
    click(screen.getByRole('button', { name: 'Drape again' }));
    expect(page.asked()).toEqual([['mend', { kind: 'drape' }]]);
    // What has been undone again is no change.
    page.change((state) => {
      const { history } = state.editing;
      history.value = history.value.map((one) => (one.number === 2 ? { ...one, undone: true } : one));
    });
    expect(screen.queryByText('Changed since this drape')).toBeNull();
  });

  it('names the pieces around an opening, and offers to look for their seams', () => {
    page.change((state) => {
      state.pieces.value = ready({ pieces: [squareOf('front', 0, 0, 10), squareOf('back', 20, 0, 10)], seams: [] });
      const about = [{ thing: 'piece' as const, id: 'front' }];
      const slit = { code: 'worn.slit', severity: 'warning' as const, message: 'an opening', where: '', about, place: [0, 0, 0] as [number, number, number], repaired: false };
      state.report.value = ready(reportOf({ worn: 'partly', findings: [slit] }));
    });
    drape({ state: 'succeeded' });
    page.show(<OutcomeList />);
    expect(screen.getByRole('heading').textContent).toBe('An opening is left');
    expect(screen.queryByText('It is not worn as it should be')).toBeNull();
    click(screen.getByRole('button', { name: 'front' }));
    click(screen.getByRole('button', { name: 'Look for its seams' }));
    expect(page.asked()).toEqual([
      ['select', 'front'],
      ['mend', { kind: 'sew' }],
    ]);
  });

  it('names the seam that stayed open by its pieces, and offers to turn it over', () => {
    const pieces = [squareOf('front', 0, 0, 10), squareOf('back', 20, 0, 10)];
    const seams = [{ ...seamOf('seam3', ['front', 'e1'], ['back', 'e3']), length_a_mm: 10, length_b_mm: 10, issues: [] }];
    page.change((state) => {
      state.pieces.value = ready({ pieces, seams });
      state.report.value = ready(reportOf({ open_seams: [{ id: 'seam3', gap_mm: 150 }], seam_gap_max_mm: 150 }));
    });
    drape({ state: 'succeeded', reason_code: 'open_seam' });
    page.show(<OutcomeList />);
    const chip = screen.getByRole('button', { name: '1 front to back' });
    fireEvent.pointerEnter(chip);
    click(chip);
    click(screen.getByRole('button', { name: 'Turn seam 1 over and drape' }));
    expect(page.asked()).toEqual([
      ['pattern.lightSeam', 'seam3'],
      ['pattern.pointAtSeam', 'seam3'],
      ['mend', { kind: 'reverse', seam: 'seam3' }],
    ]);
    page.show(<SeamChip seam="seam3" />);
    expect(screen.getByRole('button', { name: '1 front to back' })).toBeTruthy();
  });

  it('looks for seams of pieces that were left out, but stands those anew that are sewn on', () => {
    const pieces = ['front', 'sleeve', 'cuff', 'pocket'].map((id, i) => squareOf(id, 20 * i, 0, 10));
    const sewn = (id: string, a: string, b: string) => ({ ...seamOf(id, [a, 'e1'], [b, 'e3']), length_a_mm: 10, length_b_mm: 10, issues: [] });
    const seams = [sewn('s1', 'cuff', 'sleeve'), sewn('s2', 'sleeve', 'front'), sewn('s3', 'pocket', 'pocket')];
    const leave = (...ids: string[]): void =>
      page.change((state) => {
        const about = ids.map((id) => ({ thing: 'piece' as const, id }));
        const finding = { code: 'piece.left_out', severity: 'warning' as const, message: 'out', where: '', about, place: [0, 0, 0] as [number, number, number], repaired: false };
        state.pieces.value = ready({ pieces, seams });
        state.report.value = ready(reportOf({ worn: 'partly', findings: [finding] }));
      });
    leave('sleeve', 'cuff', 'pocket');
    drape({ state: 'succeeded' });
    page.show(<OutcomeList />);
    click(screen.getByRole('button', { name: 'Look for its seams' }));
    expect(page.asked()).toEqual([['mend', { kind: 'sew', piece: 'pocket' }]]);
    leave('sleeve', 'cuff');
    expect(screen.getByText(/^They are sewn on, but/)).toBeTruthy();
    click(screen.getByRole('button', { name: 'Arrange anew and drape' }));
    click(screen.getByRole('button', { name: 'Place it by hand' }));
    expect(page.asked()).toEqual([['mend', { kind: 'arrange' }], ['mend', { kind: 'place', piece: 'sleeve' }]]);
  });

  it('says that a seam’s sides are not made for each other, and leads to it; of what is not worn seams may be wanting', () => {
    const pieces = [squareOf('front', 0, 0, 10), squareOf('back', 20, 0, 10)];
    const seams = [{ ...seamOf('seam3', ['front', 'e1'], ['back', 'e3']), length_a_mm: 415, length_b_mm: 339, issues: [] }];
    const off = { code: 'worn.ring_off', severity: 'warning' as const, message: 'a ring is off', where: '', about: [], place: [0, 0, 0] as [number, number, number], repaired: false };
    page.change((state) => {
      state.pieces.value = ready({ pieces, seams });
      state.report.value = ready(reportOf({ open_seams: [{ id: 'seam3', gap_mm: 7 }], seam_gap_max_mm: 7, worn: 'partly', findings: [off] }));
    });
    drape({ state: 'succeeded', reason_code: 'open_seam' });
    page.show(<OutcomeList />);
    expect(screen.getByText(/^One side of the widest is much longer/)).toBeTruthy();
    click(screen.getByRole('button', { name: 'See the seam' }));
    click(screen.getByRole('button', { name: 'Look for its seams' }));
    expect(page.asked()).toEqual([
      ['mend', { kind: 'seam', seam: 'seam3' }],
      ['mend', { kind: 'sew' }],
    ]);
  });

  it('offers more time to cloth that still moved', () => {
    page.change((state) => {
      state.pieces.value = ready({ pieces: [], seams: [], max_time_s: 8 });
      state.report.value = ready(reportOf({}));
    });
    drape({ state: 'succeeded', reason_code: 'time' });
    page.show(<OutcomeList />);
    click(screen.getByRole('button', { name: 'Give it 16 s and drape' }));
    expect(page.asked()).toEqual([['mend', { kind: 'time', max_time_s: 16 }]]);
  });

  it('shows the seam whose edges do not fit each other, and turns over one that is twisted', () => {
    page.change((state) => {
      const seams = [{ ...seamOf('side', ['a', 'e1'], ['b', 'e3']), length_a_mm: 10, length_b_mm: 90, issues: [] }];
      state.pieces.value = ready({ pieces: [squareOf('a', 0, 0, 10), squareOf('b', 20, 0, 10)], seams });
    });
    const buttons = (): (string | null)[] =>
      [...document.querySelectorAll('.reason .button-row button')].map((one) => one.textContent);
    drape({ state: 'failed', reason_code: 'seam.length_ratio', reason: 'too long', reason_where: 'seam side' });
    page.show(<OutcomeList />);
    expect(buttons()).toEqual(['See the seam', 'Turn seam 1 over and drape']);
    drape({ state: 'failed', reason_code: 'seam.twisted', reason: 'twisted', reason_where: 'seam side' });
    expect(buttons()[0]).toBe('Turn seam 1 over and drape');
  });

  it('raises no alarm when somebody cancelled it', () => {
    drape({ state: 'cancelled', reason_code: 'cancelled' });
    page.show(<DrapeFigures />);
    expect(screen.getByRole('heading').textContent).toBe('The drape was cancelled');
    expect(screen.queryByRole('alert')).toBeNull();
  });

  it('lists the pieces under their fabrics; a click selects, and lets go again', () => {
    const pieces = ['twill', 'own', 'f', ''].map((fabric, i) => ({ ...squareOf('abcd'[i]!, 0, 0, 10), fabric }));
    page.change((state) => {
      state.pieces.value = ready({ pieces, seams: [] });
      state.editing.fabrics.value = [fabricOf('twill'), fabricOf('rib')];
      state.editing.ownFabrics.value = [{ id: 'own', name: '', like: 'rib', differs: false }];
    });
    page.show(<DrapeFigures />);
    const titles = ['How it is draped', 'Title of twill', 'Title of rib', 'f', 'Fabric'];
    expect(screen.getAllByRole('heading').map((one) => one.textContent)).toEqual(titles);
    const a = screen.getByRole('button', { name: 'a' });
    click(a);
    expect(page.state.selected.value).toBe('a');
    expect(a.getAttribute('aria-pressed')).toBe('true');
    click(a);
    expect(page.state.selected.value).toBeNull();
    fireEvent.pointerEnter(a);
    expect(page.state.hovered.value).toBe('a');
  });
});

describe('the results', () => {
  const files = { 'three-quarter.png': 2000, 'front.png': 1000, 'thumbnail.png': 10, 'final.glb': 123_456 };

  it('are none before a drape, and none yet while it runs', () => {
    page.show(<Results resultUrl={resultUrl} />);
    expect(screen.getByText('Nothing has been draped yet.')).toBeTruthy();
    drape();
    expect(screen.getByText(/are kept here when the drape has ended/)).toBeTruthy();
  });

  it('are none after a drape that left none', () => {
    drape({ state: 'failed' });
    page.show(<Results resultUrl={resultUrl} />);
    expect(screen.getByText('This drape ended without results.')).toBeTruthy();
  });

  it('can be taken along, each with what it is for and its size', () => {
    drape({ state: 'succeeded', results: files });
    page.show(<Results resultUrl={resultUrl} />);
    const links = screen.getAllByRole('link');
    expect(links.map((link) => link.getAttribute('href'))).toEqual([
      '/results/j_1/final.glb',
      '/results/j_1/three-quarter.png',
      '/results/j_1/front.png',
    ]);
    expect(links[0]!.textContent).toBe('GLBColoured model for 3D programs and the web123 kB');
    expect(links[0]!.getAttribute('download')).toBe('Skirt final.glb');
    expect(links[1]!.textContent).toBe('PNGThree-quarter still2.0 kB');
  });

  it('have movies made when they are asked for, and say why one is not', async () => {
    const order = { name: 'turntable-720x900-25.mp4', fraction: 0, href: null, error: null };
    const asked: string[] = [];
    const movies = {
      makeMovie: async (job: string, kind: 'drape' | 'turntable'): Promise<MovieOrder> => {
        asked.push(`${job} ${kind}`);
        if (kind === 'turntable') return { ...order, state: 'made', fraction: 1 };
        return { ...order, state: 'failed', error: { code: 'movie.no_ffmpeg', detail: 'ffmpeg is not installed' } };
      },
      movies: async () => [],
      resultUrl,
    };
    const film = { 'drape.film': 900 };
    page.show(<Movies job={jobOf({ state: 'running', results: film })} making={movies} />);
    expect(screen.queryByRole('button', { name: /Turntable/ })).toBeNull();
    page.show(<Movies job={jobOf({ state: 'succeeded', results: film })} making={movies} />);
    click(screen.getByRole('button', { name: /Turntable/ }));
    const link = await screen.findByRole('link', { name: /Turntable/ });
    expect(link.getAttribute('href')).toBe('/results/j_1/turntable-720x900-25.mp4');
    click(screen.getByRole('button', { name: /Movie of the drape/ }));
    expect(await screen.findByText('ffmpeg is not installed')).toBeTruthy();
    expect(asked).toEqual(['j_1 turntable', 'j_1 drape']);
  });

  it('have pictures taken from where the 3D view is seen, and keep their list', async () => {
    const order = { name: 'still-from-1.png', fraction: 0, href: null, error: null };
    const wishes: StillWish[] = [];
    let kept: StillOrder[] = [];
    const taking = {
      takeStill: async (_: string, wish: StillWish): Promise<StillOrder> => {
        wishes.push(wish);
        kept = [{ ...order, state: 'made', fraction: 1 }];
        return kept[0]!;
      },
      takenStills: async () => kept,
      resultUrl,
    };
    const film = { 'drape.film': 900 };
    page.show(<Pictures job={jobOf({ state: 'running', results: film })} taking={taking} />);
    expect(screen.queryByRole('button')).toBeNull();
    page.show(<Pictures job={jobOf({ state: 'succeeded', results: film })} taking={taking} />);
    const button = screen.getByRole<HTMLButtonElement>('button', { name: /Picture from here/ });
    expect(button.disabled).toBe(true);
    page.change((state) => (state.lookingFrom.value = () => ({ eye: [0, 1, 3], target: [0, 1, 0], angle: 32, aspect: 2 })));
    click(screen.getByRole('checkbox', { name: 'Without a backdrop' }));
    click(button);
    const link = await screen.findByRole('link', { name: 'Picture 1' });
    expect(link.getAttribute('href')).toBe('/results/j_1/still-from-1.png');
    expect(wishes).toEqual([{ eye: [0, 1, 3], target: [0, 1, 0], angle: 32, width: 1280, height: 640, transparent: true }]);
  });

  it('are of the map that is shown, unless the cloth itself is wanted', async () => {
    const maps: StillWish['map'][] = [];
    const taking = {
      takeStill: async (_: string, wish: StillWish): Promise<StillOrder> => {
        maps.push(wish.map);
        return { name: 'still-from-1.png', state: 'made', fraction: 1, href: null, error: null };
      },
      takenStills: async () => [],
      resultUrl,
    };
    page.change((state) => {
      state.lookingFrom.value = () => ({ eye: [0, 1, 3], target: [0, 1, 0], angle: 32, aspect: 1 });
      state.mapKind.value = 'room';
    });
    page.show(<Pictures job={jobOf({ state: 'succeeded', results: { 'drape.film': 900 } })} taking={taking} />);
    const take = (): void => void click(screen.getByRole('button', { name: /Picture from here/ }));
    take();
    await screen.findByRole('link', { name: 'Picture 1' });
    click(screen.getByRole('checkbox', { name: 'Coloured by room to the body, with the legend' }));
    take();
    page.change((state) => (state.mapKind.value = null));
    expect(screen.queryByRole('checkbox', { name: /^Coloured by/ })).toBeNull();
    expect(maps).toEqual(['ease', undefined]);
  });

  it('say why a picture could not be taken', async () => {
    const taking = {
      takeStill: async (): Promise<StillOrder> => {
        throw new ApiError(409, 'still.too_many', 'the job has as many stills as are kept (40)');
      },
      takenStills: async () => [],
      resultUrl,
    };
    page.change((state) => (state.lookingFrom.value = () => ({ eye: [0, 1, 3], target: [0, 1, 0], angle: 32, aspect: 1 })));
    page.show(<Pictures job={jobOf({ state: 'succeeded', results: { 'drape.film': 900 } })} taking={taking} />);
    click(screen.getByRole('button', { name: /Picture from here/ }));
    expect(await screen.findByText('the job has as many stills as are kept (40)')).toBeTruthy();
  });

  it('show a still large, until it is closed', () => {
    drape({ state: 'succeeded', results: files });
    page.show(<Results resultUrl={resultUrl} />);
    click(screen.getByRole('button', { name: 'Front still, enlarge' }));
    const large = screen.getByRole('dialog', { name: 'Front still' });
    expect(within(large).getByRole('img').getAttribute('src')).toBe('/results/j_1/front.png');
    click(within(large).getByRole('button', { name: 'Close' }));
    expect(screen.queryByRole('dialog')).toBeNull();
  });

  it('have the report in words, and say while it comes and why it does not', () => {
    drape({ state: 'succeeded', results: files });
    page.change((state) => (state.report.value = { state: 'loading' }));
    page.show(<Results resultUrl={resultUrl} />);
    expect(screen.getByRole('status').textContent).toBe('Reading the report…');
    page.change((state) => (state.report.value = ready(reportOf({ seam_gap_max_mm: 4 }))));
    const lines = [...document.querySelectorAll('.report li')];
    expect(lines.map((line) => line.querySelector('b')!.textContent)).toContain('Settled at 3.50 s');
    expect(lines.filter((line) => line.className === 'verdict-warn').map((line) => line.textContent)).toEqual([
      'Seams4.00 mmThe widest seam is open by 4.00 mm.',
    ]);
    const error = new ApiError(404, 'store.not_found', 'It is gone.');
    page.change((state) => (state.report.value = { state: 'failed', error }));
    expect(screen.getByText('It is gone.').textContent).toContain('store.not_found');
  });
});

describe('drapes beside each other', () => {
  const ended = (id: string, more: Partial<Job> = {}): Job =>
    jobOf({ id, state: 'succeeded', results: { 'final.obj': 9 }, ...more });

  it('are chosen from the result of one', () => {
    page.show(<CompareWith job={ended('j_2')} />);
    expect(screen.queryByRole('combobox')).toBeNull();
    page.change((state) => (state.jobs.value = ready([ended('j_1', { project_revision: 3 }), ended('j_2')])));
    fireEvent.change(screen.getByRole('combobox', { name: 'Compare with' }), { target: { value: 'j_1' } });
    expect(page.asked()).toEqual([['open', { name: 'compare', left: 'j_1', right: 'j_2' }]]);
  });

  it('have their figures in one table once both are there', () => {
    const side = (id: string, particles: number): Compared => ({
      state: 'ready',
      value: {
        job: ended(id),
        topology: {
          epoch: 0,
          vertexCount: 0,
          origin: [0, 0, 0],
          step: 1e-4,
          pieces: [],
          rest: new Float32Array(0),
          triangles: new Uint32Array(0),
          sewn: new Uint32Array(0),
        },
        positions: new Float32Array(0),
        body: null,
        pieces: [],
        looks: new Map(),
        finishes: new Map(),
        report: reportOf({ particles }),
      },
    });
    page.change((state) => (state.comparison.left.value = side('j_1', 1200)));
    page.show(<ComparisonPanel />);
    expect(screen.queryByRole('table')).toBeNull();
    page.change((state) => (state.comparison.right.value = side('j_2', 4800)));
    const differing = [...document.querySelectorAll('.differs')].map((row) => row.textContent);
    expect(differing).toEqual(['Particles1,2004,800']);
  });
});
