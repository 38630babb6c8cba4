// @vitest-environment jsdom
import { fireEvent, screen } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { click, openPage, type Page } from './page';
import { makeApi } from '../../src/api/Api';
import type { Sweep, SweepCell, SweepFigures } from '../../src/api/sweeps';
import type { Fabric } from '../../src/api/types';
import { SweepDialog } from '../../src/panels/SweepDialog';
import { SweepList } from '../../src/panels/SweepList';
import { SweepPanel } from '../../src/panels/SweepPanel';
import { ready } from '../../src/state/AppState';

const api = makeApi();
let page: Page;
beforeEach(() => {
  page = openPage();
});

const figuresOf = (more: Partial<SweepFigures> = {}): SweepFigures => ({
  settled: true, stop_reason: 'settled', worn: 'yes', bust: null, waist: { fit: 'fits', ease_mm: 12 },
  hip: { fit: 'too_tight', ease_mm: -21 }, warp_p99: 0.01, weft_p99: 0.035, shear_p99: 0.1, cloth_body: 0, cloth_cloth: 0,
  worst_body: 0, worst_cloth: 0, open_seams: 0, cpu_s: 4.2, simulated_s: 2, particles: 3000, hash: 'a', ...more,
});

const cellOf = (more: Partial<SweepCell> = {}): SweepCell => ({
  body: 'eu36', fabric: 'poplin', job: 'j_1', state: 'succeeded', reason_code: 'settled', reason: '', fraction: 1,
  pictured: true, figures: figuresOf(), ...more,
});

const sweepOf = (cells: SweepCell[], more: Partial<Sweep> = {}): Sweep => ({
  id: 's_1', project_id: 'p_1', project_revision: 1, name: 'Skirt', created_ms: 1, ended: false, fraction: 0.25,
  bodies: ['eu36', 'Anna'], fabrics: ['poplin'],
  counts: { queued: 1, running: 0, paused: 0, succeeded: 1, failed: 0, cancelled: 0, removed: 0 }, cells, ...more,
});

describe('the page of a sweep', () => {
  const show = (sweep: Sweep): void => {
    page.change((state) => {
      state.sweeps.shown.value = ready(sweep);
      state.editing.fabrics.value = [{ name: 'poplin', title: 'Poplin' } as Fabric];
    });
    page.show(<SweepPanel resultUrl={api.resultUrl} sweeps={api} />);
  };

  it('has a picture for each drape that has ended, which leads to it', () => {
    show(sweepOf([cellOf(), cellOf({ body: 'Anna', job: 'j_2', state: 'queued', figures: null, pictured: false, fraction: 0 })]));
    const done = screen.getByRole('link', { name: 'EU 36, Poplin: worn, at rest' });
    expect(done.getAttribute('href')).toBe('#/jobs/j_1');
    expect(done.querySelector('img')!.getAttribute('src')).toBe('/api/v1/jobs/j_1/results/front.png/small?width=400');
    const waits = screen.getByRole('link', { name: 'Anna, Poplin: Queued' });
    expect(waits.querySelector('img')).toBeNull();
    expect(screen.getByRole('columnheader', { name: 'Poplin' })).toBeTruthy();
    expect(screen.getByText('1 of 2 ended', { exact: false })).toBeTruthy();
  });

  it('tells ease, stretch and time, and what is too tight', () => {
    show(sweepOf([cellOf(), cellOf({ body: 'Anna', job: null, state: 'removed', figures: null, pictured: false })]));
    expect(screen.getByText('−2.1 cm').closest('span')!.className).toBe('tight');
    expect(screen.getByText('+1.2 cm').closest('span')!.className).toBe('');
    expect(screen.getByText('3.5 %')).toBeTruthy();
    expect(screen.getByText('removed').closest('a')).toBeNull();
  });

  it.each([
    [figuresOf({ worn: 'no' }), 'not worn'],
    [figuresOf({ settled: false }), 'still moves'],
    [figuresOf({ worst_cloth: 2 }), '2 crossings'],
    [figuresOf({ worn: 'partly' }), 'a seam is open'],
    [figuresOf({ worn: null }), 'at rest'],
  ])('says of a drape what is wrong with it %#', (figures, word) => {
    show(sweepOf([cellOf({ figures }), cellOf({ body: 'Anna' })]));
    expect(screen.getByText(word)).toBeTruthy();
  });

  it('cancels all while it is under way, and is removed once it has ended', () => {
    show(sweepOf([cellOf(), cellOf()]));
    click(screen.getByText('Cancel all'));
    expect(page.asked()).toContainEqual(['sweeps.cancel', 's_1']);
    show(sweepOf([cellOf(), cellOf()], { ended: true }));
    click(screen.getByLabelText(/Remove the sweep/));
    click(screen.getByLabelText(/Really remove the sweep/));
    expect(page.asked()).toContainEqual(['sweeps.remove', 's_1']);
    const links = ['Contact sheet', 'Table (CSV)'].map((text) => screen.getByText(text).closest('a')!.getAttribute('href'));
    expect(links).toEqual(['/api/v1/sweeps/s_1/sheet.png', '/api/v1/sweeps/s_1/table.csv']);
  });

  it('stands in the rail', () => {
    page.change((state) => (state.sweeps.list.value = ready([sweepOf([])])));
    page.show(<SweepList />);
    expect(screen.getByText('Skirt').closest('a')!.getAttribute('href')).toBe('#/sweeps/s_1');
    expect(screen.getByText('1 of 2 ended')).toBeTruthy();
  });
});

describe('the dialog of a sweep', () => {
  it('counts the drapes of what is ticked, and starts them', () => {
    page.change((state) => {
      state.dressing.tables.value = {
        presets: [{ name: 'eu36', sex: 'female', measures_cm: {} }, { name: 'eu40', sex: 'female', measures_cm: {} }],
        formats: [],
      } as never;
      state.editing.fabrics.value = ['poplin', 'felt'].map((name) => ({
        name, title: name, fibre: 'cotton', weave: 'plain', construction: 'woven', areal_mass_g_m2: 100,
        bend_warp_un_m: 9, bend_weft_un_m: 9, colour: [1, 1, 1],
      } as unknown as Fabric));
      state.sweeps.choosing.value = true;
    });
    page.show(<SweepDialog />);
    click(screen.getByLabelText('EU 36'));
    click(screen.getByLabelText('EU 40'));
    click(screen.getByLabelText('The project’s own body'));
    click(screen.getByLabelText(/poplin/));
    fireEvent.submit(screen.getByText('Start 4 drapes').closest('form')!);
    expect(page.asked()).toContainEqual(['sweeps.begin', ['eu36', 'eu40'], ['', 'poplin']]);
    click(screen.getByLabelText('EU 36'));
    click(screen.getByLabelText('EU 40'));
    expect(screen.getByText<HTMLButtonElement>('Start 0 drapes').closest('button')!.disabled).toBe(true);
  });
});
