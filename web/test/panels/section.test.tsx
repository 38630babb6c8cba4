// @vitest-environment jsdom
import { fireEvent, screen, within } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { click, openPage, type Page } from './page';
import { SectionPanel } from '../../src/panels/SectionPanel';
import { ready, type AppState } from '../../src/state/AppState';
import type { Outline } from '../../src/state/planeCut';
import type { Section } from '../../src/state/section';
import { listenForKeys } from '../../src/tools/keys';
import { unit } from '../../src/texts/units';
import { jobOf } from '../fakes';

let page: Page;
beforeEach(() => {
  page = openPage();
  page.change(draped);
});

function draped(state: AppState): void {
  state.jobs.value = ready([jobOf({ state: 'succeeded', results: { 'final.obj': 1 } })]);
  state.covered.value = true;
  state.tab.value = 'result';
}

const square = (half: number): Outline => ({
  places: [[-half, -half], [half, -half], [half, half], [-half, half]],
  closed: true,
  length: 8 * half,
  flat: 8 * half + 0.02,
});

const cut: Section = {
  height: 1.0832,
  range: { low: 0.8, high: 1.4 },
  body: [square(0.1)],
  cloth: [square(0.12)],
  girths: [{ part: 'trunk', body: 0.8, worn: 0.96, flat: 0.98, room: { least: 0.004, median: 0.02, most: 0.03 }, layers: 2 }],
  open: { count: 0, flat: 0 },
};

const show = (section: Partial<Section> = {}): void => {
  page.change((state) => {
    state.section.shown.value = true;
    state.section.levels.value = [
      { name: 'bust', height: 1.3 },
      { name: 'hip', height: 0.7 },
    ];
    state.section.cut.value = { ...cut, ...section };
  });
  page.show(<SectionPanel />);
};

describe('the section’s panel', () => {
  it('is opened and closed by its button, and is not there without cloth', () => {
    page.show(<SectionPanel />);
    expect(screen.queryByRole('slider')).toBeNull();
    click(screen.getByRole('button', { name: 'Show' }));
    expect(page.state.section.shown.value).toBe(true);
    page.change((state) => (state.covered.value = false));
    expect(screen.queryByRole('region')).toBeNull();
  });

  it('tells girths, ease and room in the unit that was chosen', () => {
    show();
    const row = within(screen.getByRole('row', { name: /Trunk/ }));
    expect(row.getAllByRole('cell').map((cell) => cell.textContent)).toEqual(['80.0 cm', '98.0 cm', '+18.0 cm']);
    screen.getByText('Hangs at 96.0 cm. Room from 4.0 mm, half of it under 20.0 mm. The tightest of 2 layers.');
    page.change(() => (unit.value = 'inch'));
    expect(row.getAllByRole('cell')[2]!.textContent).toBe('+7.09 in');
    show({ girths: [{ ...cut.girths[0]!, flat: 0.77 }] });
    expect(row.getAllByRole('cell')[2]!.textContent).toBe('−1.18 in');
  });

  it('moves the plane by its slider and to heights with names, where there is cloth', () => {
    show();
    expect(screen.getByRole('slider').getAttribute('aria-valuetext')).toBe('108.3 cm above the floor');
    fireEvent.input(screen.getByRole('slider'), { target: { value: '1.2' } });
    expect(page.state.section.height.value).toBe(1.2);
    click(screen.getByRole('button', { name: 'Bust' }));
    expect(page.state.section.height.value).toBe(1.3);
    expect(screen.getByRole('button', { name: 'Hip' })).toHaveProperty('disabled', true);
  });

  it('draws both outlines from above, and says what does not close', () => {
    show({ open: { count: 2, flat: 0.5 } });
    const drawing = screen.getByRole('img', { name: /108.3 cm above the floor/ });
    expect([...drawing.querySelectorAll('.cut-body, .cut-cloth')].map((path) => path.getAttribute('d'))).toEqual([
      'M-100.0 -100.0L100.0 -100.0L100.0 100.0L-100.0 100.0Z',
      'M-120.0 -120.0L120.0 -120.0L120.0 120.0L-120.0 120.0Z',
    ]);
    screen.getByText('2 outlines of cloth not closed, together 50.0 cm.');
    show({ cloth: [], girths: [] });
    screen.getByText('There is no cloth at this height.');
  });

  it('is turned to by a key from any panel', () => {
    const stop = listenForKeys(page.commands, page.state);
    page.change((state) => (state.tab.value = 'pattern'));
    fireEvent.keyDown(document.body, { key: 'c' });
    expect([page.state.section.shown.value, page.state.tab.value]).toEqual([true, 'result']);
    fireEvent.keyDown(document.body, { key: 'c' });
    expect(page.state.section.shown.value).toBe(false);
    stop();
  });
});
