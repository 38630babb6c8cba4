// @vitest-environment jsdom
import { fireEvent, screen, within } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { ApiError } from '../../src/api/http';
import { VersionList } from '../../src/panels/VersionList';
import { ready } from '../../src/state/AppState';
import { jobOf } from '../fakes';
import { click, openPage, type Page } from './page';

let page: Page;
beforeEach(() => {
  page = openPage();
  page.show(<VersionList />);
});

const version = { revision: 1, created_ms: 1000, current: false, jobs: [] };

describe('the list of versions', () => {
  it('names the state by what is typed', () => {
    const keep = screen.getByRole('button', { name: 'Keep' });
    expect(keep).toHaveProperty('disabled', true);
    fireEvent.input(screen.getByRole('textbox', { name: 'Name of this state' }), { target: { value: 'with a slit' } });
    expect(keep).toHaveProperty('disabled', false);
    fireEvent.submit(keep.closest('form')!);
    expect(page.asked()).toEqual([['versions.name', 'with a slit']]);
    page.change((state) => (state.versions.problem.value = new ApiError(409, 'versions.taken', 'There is one.')));
    expect(screen.getByRole('alert').textContent).toContain('versions.taken');
  });

  it('leads back to each but the one that the project stands at, and to their drapes', () => {
    page.change((state) => {
      state.jobs.value = ready([jobOf({ id: 'j_1', state: 'succeeded' })]);
      state.versions.list.value = [
        { ...version, id: 'v_2', name: 'with a slit', current: true },
        { ...version, id: 'v_1', name: 'as drawn', jobs: ['j_1', 'j_gone'] },
      ];
    });
    const [now, before] = screen.getAllByRole('listitem');
    within(now!).getByText('as it is now');
    expect(within(now!).queryByRole('button', { name: /Go back/ })).toBeNull();
    expect(within(before!).getByRole('link').getAttribute('href')).toBe('#/jobs/j_1');
    click(screen.getByRole('button', { name: 'Go back to as drawn' }));
    expect(page.asked()).toEqual([['versions.restore', 'v_1']]);
    click(screen.getByRole('button', { name: /Remove the version as drawn/ }));
    expect(page.asked()).toEqual([]);
    click(within(before!).getByText('Remove?'));
    expect(page.asked()).toEqual([['versions.remove', 'v_1']]);
  });
});
