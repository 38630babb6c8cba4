import { describe, expect, it, vi } from 'vitest';
import { ApiError } from '../src/api/http';
import type { Sweep, SweepApi } from '../src/api/sweeps';
import { Poller } from '../src/commands/Poller';
import { SweepCommands } from '../src/commands/SweepCommands';
import { AppState, ready } from '../src/state/AppState';
import { newestJobOf } from '../src/state/jobs';
import { formatRoute, parseRoute, type Route } from '../src/state/routes';
import { fakeApi, jobOf } from './fakes';

const sweepOf = (more: Partial<Sweep> = {}): Sweep => ({
  id: 's_1', project_id: 'p_1', project_revision: 1, name: 'Skirt', created_ms: 1, ended: false, fraction: 0,
  bodies: ['eu36'], fabrics: ['poplin'],
  counts: { queued: 1, running: 0, paused: 0, succeeded: 0, failed: 0, cancelled: 0, removed: 0 }, cells: [], ...more,
});

function begin(more: Partial<SweepApi> = {}) {
  const state = new AppState();
  const opened: Route[] = [];
  const api = fakeApi(more);
  const commands = new SweepCommands(state, api, (route) => opened.push(route), () => 'key', () => undefined);
  return { state, opened, commands };
}

const settled = (): Promise<void> => new Promise((done) => setTimeout(done));

describe('sweeps', () => {
  it('stand at an address of their own', () => {
    const route = { name: 'sweep', id: 's_1' } as const;
    expect(formatRoute(route)).toBe('#/sweeps/s_1');
    expect(parseRoute('#/sweeps/s_1')).toEqual(route);
  });

  it('are begun with the project’s own as an empty wish, once', async () => {
    const submitSweep = vi.fn(async () => sweepOf());
    const { state, opened, commands } = begin({ submitSweep });
    state.route.value = { name: 'project', id: 'p_1' };
    await Promise.all([commands.begin(['', 'eu36'], ['poplin']), commands.begin(['eu36'], ['poplin'])]);
    expect(submitSweep.mock.calls).toEqual([[{ project_id: 'p_1', bodies: [{}, 'eu36'], fabrics: ['poplin'] }, 'key']]);
    expect(opened).toEqual([{ name: 'sweep', id: 's_1' }]);
    expect(state.sweeps.busy.value).toBe(false);
  });

  it('say what is wrong with them, and can be begun again', async () => {
    const { state, opened, commands } = begin({
      submitSweep: () => Promise.reject(new ApiError(422, 'sweep.duplicate', 'Twice.', '/bodies/1')),
    });
    state.route.value = { name: 'project', id: 'p_1' };
    await commands.begin(['eu36', 'eu36'], ['']);
    expect(opened).toEqual([]);
    expect(state.notices.value).toMatchObject([{ code: 'sweep.duplicate', where: '/bodies/1' }]);
    expect(state.sweeps.busy.value).toBe(false);
  });

  it('are fetched when they are shown and whenever their row has changed', async () => {
    const sweep = vi.fn(async () => sweepOf());
    const { state, commands } = begin({ sweep });
    const stop = commands.start();
    state.route.value = { name: 'sweep', id: 's_1' };
    await settled();
    expect(sweep).toHaveBeenCalledTimes(1);
    expect(state.sweeps.shown.value).toMatchObject({ state: 'ready' });
    const row = sweepOf();
    state.sweeps.list.value = ready([row]);
    state.sweeps.list.value = ready([row]);
    await settled();
    expect(sweep).toHaveBeenCalledTimes(2);
    state.sweeps.list.value = ready([sweepOf({ fraction: 0.5 })]);
    await settled();
    expect(sweep).toHaveBeenCalledTimes(3);
    state.route.value = { name: 'home' };
    expect(state.sweeps.shown.value).toBeNull();
    stop();
  });

  it('are cancelled, and leave the page when they are removed', async () => {
    const { state, opened, commands } = begin({ cancelSweep: async () => sweepOf({ ended: true }) });
    state.route.value = { name: 'sweep', id: 's_1' };
    state.sweeps.list.value = ready([sweepOf()]);
    await commands.cancel('s_1');
    expect(state.sweeps.shown.value).toMatchObject({ value: { ended: true } });
    await commands.remove('s_1');
    expect(opened).toEqual([{ name: 'home' }]);
    expect(state.sweeps.list.value).toEqual(ready([]));
  });

  it('keep their drapes out of the lists, but for one that the address names', async () => {
    const state = new AppState();
    const cell = jobOf({ id: 'j_cell', created_ms: 9e12, sweep: { id: 's_1', body: 0, fabric: 0 } });
    const job = vi.fn(async () => cell);
    const poller = new Poller(state, fakeApi({ job, jobs: async () => [jobOf({ id: 'j_1' })] }), () => undefined);
    await poller.refresh();
    expect(job).not.toHaveBeenCalled();
    state.route.value = { name: 'job', id: 'j_cell' };
    await poller.refresh();
    poller.stop();
    expect(state.job.value?.id).toBe('j_cell');
    expect(newestJobOf(state.allJobs.value, cell.project_id)?.id).toBe('j_1');
  });
});
