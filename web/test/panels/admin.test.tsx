// @vitest-environment jsdom
import { screen, within } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { click, openPage, type Page } from './page';
import { ApiError } from '../../src/api/http';
import { AdminPanel } from '../../src/panels/AdminPanel';
import { TopBar } from '../../src/panels/TopBar';
import { ready } from '../../src/state/AppState';
import { accountOf, adminJobOf, loadOf, sessionOf } from '../adminView';

let page: Page;
beforeEach(() => {
  page = openPage();
});

const table = (name: string): string[][] =>
  within(within(screen.getByRole('region', { name })).getByRole('table'))
    .getAllByRole('row')
    .slice(1)
    .map((row) => [...row.children].map((cell) => cell.textContent));

describe('the service for whoever runs it', () => {
  it('shows its load, who there is, and what has not ended', () => {
    const accounts = [
      accountOf('anna', { admin: true, bytes: 2_500_000_000, projects: 12, jobs: 1500, unfinished_jobs: 1 }),
      accountOf('ben', { locked: true }),
    ];
    page.change((state) => {
      state.session.value = sessionOf(['read', 'submit', 'admin']);
      state.now.value = 600_000;
      state.admin.value = ready({ load: loadOf(), accounts, jobs: [adminJobOf()] });
    });
    page.show(<AdminPanel />);
    const load = screen.getByRole('region', { name: 'Load' });
    expect(within(load).getByText('Drapes under way').nextSibling!.textContent).toBe('2');
    expect(within(load).getByText('Free on disk').nextSibling!.textContent).toBe('41.0 GB of 500.0 GB');
    expect(within(load).getByText('Kept by all').nextSibling!.textContent).toBe('2.5 GB');
    expect(within(load).queryByRole('alert')).toBeNull();
    expect(table('Accounts').map((row) => row.slice(0, 5))).toEqual([
      ['anna administrator', '2.5 GB', '12', '1,500', '1'],
      ['ben locked out', '0 B', '0', '0', '0'],
    ]);
    expect(table('Drapes that have not ended')).toEqual([
      ['Shirt', 'ben', 'Running', 'when there is time', '1 min 15 s', '5 min ago'],
    ]);
    expect(within(screen.getByRole('row', { name: /^ben/ })).getAllByRole('cell')[1]!.dataset.head).toBe('Projects');
  });

  it('locks others out and lets them in again, and nobody themselves', () => {
    const accounts = [accountOf('anna', { admin: true }), accountOf('ben', { locked: true }), accountOf('cleo')];
    page.change((state) => {
      state.session.value = sessionOf(['read', 'submit', 'admin']);
      state.admin.value = ready({ load: loadOf(), accounts, jobs: [] });
    });
    page.show(<AdminPanel />);
    expect(screen.getByText('Nothing is draped, and nothing waits.')).toBeTruthy();
    expect(table('Accounts')[0]!.at(-1)).toBe('this is you');
    expect(screen.queryByRole('button', { name: 'Lock out: anna' })).toBeNull();
    click(screen.getByRole('button', { name: 'Let in again: ben' }));
    click(screen.getByRole('button', { name: 'Lock out: cleo' }));
    expect(page.asked()).toEqual([
      ['admin.lock', 'ac_ben', false],
      ['admin.lock', 'ac_cleo', true],
    ]);
  });

  it('says what it cannot keep, and that it takes nothing new', () => {
    const load = loadOf({ ready: false, store_failures: { 'store.full': 3 } });
    page.change((state) => (state.admin.value = ready({ load, accounts: [accountOf(null)], jobs: [] })));
    page.show(<AdminPanel />);
    expect(screen.getByRole('alert').textContent).toBe('The service takes no new work at the moment.');
    expect(screen.getByText(/store\.full \(3\)/)).toBeTruthy();
    expect(table('Accounts')[0]![0]).toBe('the one user ');
  });

  it('says who works on each drape where several programs do', () => {
    const jobs = [adminJobOf(), adminJobOf({ id: 'j_2', holder: 'worker-3' }), adminJobOf({ id: 'j_3', holder: '' })];
    page.change((state) => (state.admin.value = ready({ load: loadOf(), accounts: [], jobs })));
    page.show(<AdminPanel />);
    expect(table('Drapes that have not ended').map((row) => row.at(-1))).toEqual(['worker-2', 'worker-3', '–']);
  });

  it('says kindly to others that it is not theirs, and nothing to who has to log in', () => {
    const error = new ApiError(403, 'auth.scope', 'this wants the scope admin');
    page.change((state) => {
      state.session.value = sessionOf(['read', 'submit']);
      state.admin.value = { state: 'failed', error };
    });
    page.show(<AdminPanel />);
    expect(screen.getByText(/anna is none of them/)).toBeTruthy();
    expect(screen.queryByRole('alert')).toBeNull();
    page.change((state) => {
      state.session.value = null;
      state.shut.value = true;
    });
    expect(screen.queryByRole('alert')).toBeNull();
  });

  it('waits for it, and says who may not see it', () => {
    page.show(<AdminPanel />);
    expect(screen.getByRole('status').textContent).toBe('Looking at the service…');
    const error = new ApiError(403, 'auth.scope', 'this wants the scope admin');
    page.change((state) => (state.admin.value = { state: 'failed', error }));
    expect(screen.getByRole('alert').textContent).toContain('This wants the scope admin.');
  });

  it('is led to from the bar above, for those who may', () => {
    const link = (): HTMLElement | null => screen.queryByRole('link', { name: 'Service' });
    page.change((state) => (state.session.value = sessionOf(['read', 'submit'])));
    page.show(<TopBar />);
    expect(link()).toBeNull();
    page.change((state) => (state.session.value = sessionOf(['read', 'submit', 'admin'])));
    expect(link()!.getAttribute('href')).toBe('#/admin');
    page.change((state) => (state.session.value = { ...sessionOf(['read', 'submit', 'admin']), accounts: false }));
    expect(link()).toBeNull();
  });
});
