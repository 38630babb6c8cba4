import { describe, expect, it, vi } from 'vitest';
import { ApiError } from '../src/api/http';
import type { Version, VersionApi } from '../src/api/versions';
import { EditQueue } from '../src/commands/EditQueue';
import { VersionCommands } from '../src/commands/VersionCommands';
import { AppState, ready } from '../src/state/AppState';
import { madeOf, versionOf } from '../src/state/versions';
import { fakeApi, jobOf, projectOf } from './fakes';

export const versionNamed = (name: string, more: Partial<Version> = {}): Version => ({
  id: `v_${name}`, name, revision: 1, created_ms: 1000, current: false, jobs: [], ...more,
});

function begin(more: Partial<VersionApi> = {}) {
  const state = new AppState();
  const api = fakeApi(more);
  state.projects.value = ready([projectOf({ revision: 3 })]);
  state.jobs.value = ready([]);
  state.route.value = { name: 'project', id: 'p_1' };
  const edits = new EditQueue(state, api, () => undefined);
  const commands = new VersionCommands(state, api, (ask) => edits.change(ask));
  return { state, commands };
}

const settled = (): Promise<void> => new Promise((done) => setTimeout(done));

describe('versions', () => {
  it('are listed anew when the project or its drapes change, and begin anew with another project', async () => {
    const versions = vi.fn(async (project: string) => [versionNamed(project)]);
    const { state, commands } = begin({ versions });
    const stop = commands.start();
    await settled();
    expect(state.versions.list.value).toMatchObject([{ name: 'p_1' }]);
    state.now.value += 1000;
    state.jobs.value = ready([jobOf({ id: 'j_else', project_id: 'p_2' })]);
    await settled();
    expect(versions).toHaveBeenCalledTimes(1);
    state.jobs.value = ready([jobOf({ project_id: 'p_1' })]);
    await settled();
    state.projects.value = ready([projectOf({ revision: 4 }), projectOf({ id: 'p_2' })]);
    await settled();
    expect(versions).toHaveBeenCalledTimes(3);
    versions.mockRejectedValueOnce(new ApiError(404, 'store.not_found', ''));
    state.route.value = { name: 'project', id: 'p_2' };
    await settled();
    expect(state.versions.list.value).toEqual([]);
    stop();
  });

  it('are named by the revision after the edits that are under way', async () => {
    const nameVersion = vi.fn(async () => versionNamed('slit'));
    const { state, commands } = begin({ nameVersion, versions: async () => [versionNamed('slit')] });
    expect(await commands.name(' slit ')).toBe(true);
    expect(nameVersion.mock.calls).toEqual([['p_1', 3, 'slit']]);
    expect(state.versions.list.value).toHaveLength(1);
    expect(state.editing.problem.value).toBeNull();
  });

  it('say why a name was refused, at their own place', async () => {
    const nameVersion = vi.fn(async () => Promise.reject(new ApiError(409, 'versions.taken', 'There is one.')));
    const { state, commands } = begin({ nameVersion });
    expect(await commands.name('slit')).toBe(false);
    expect(state.versions.problem.value?.code).toBe('versions.taken');
    expect([state.versions.busy.value, state.editing.problem.value]).toEqual([false, null]);
  });

  it('are come back to as an edit is done', async () => {
    const restoreVersion = vi.fn(async () => projectOf({ revision: 4 }));
    const { state, commands } = begin({ restoreVersion });
    await commands.restore('v_slit');
    expect(restoreVersion.mock.calls).toEqual([['p_1', 3, 'v_slit']]);
    expect(state.project.value?.revision).toBe(4);
  });

  it('leave a drape up to date when one comes back to what it was made of', async () => {
    const { state, commands } = begin({ versions: async () => [versionNamed('first', { current: true, jobs: ['j_1'] })] });
    state.jobs.value = ready([jobOf({ id: 'j_1', project_id: 'p_1', project_revision: 1, state: 'succeeded' })]);
    expect(state.since.value).not.toBeNull();
    const stop = commands.start();
    await settled();
    expect(state.since.value).toBeNull();
    state.projects.value = ready([projectOf({ revision: 4 })]);
    expect(state.since.value, 'until it is told anew').not.toBeNull();
    stop();
  });

  it('say what a drape was made of', () => {
    const list = [versionNamed('second', { jobs: ['j_2'] }), versionNamed('first', { jobs: ['j_2', 'j_1'] })];
    expect(versionOf(list, 'j_2')?.name).toBe('second');
    expect(madeOf(list, { id: 'j_1', project_revision: 1 })).toBe('first');
    expect(madeOf(list, { id: 'j_9', project_revision: 7 })).toBe('rev 7');
  });
});
