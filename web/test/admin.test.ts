import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { AdminApi } from '../src/api/admin';
import { ApiError } from '../src/api/http';
import { AdminCommands } from '../src/commands/AdminCommands';
import { AppState, valueOf } from '../src/state/AppState';
import { formatRoute, parseRoute } from '../src/state/routes';
import { accountOf, loadOf } from './adminView';
import { fakeApi } from './fakes';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function begin(more: Partial<AdminApi> = {}) {
  const state = new AppState();
  const commands = new AdminCommands(state, fakeApi({ adminLoad: async () => loadOf(), ...more }));
  return { state, commands, stop: commands.start() };
}

const show = async (state: AppState): Promise<void> => {
  state.route.value = { name: 'admin' };
  await vi.advanceTimersByTimeAsync(0);
};

describe('the view of the service', () => {
  it('stands at an address of its own', () => {
    expect(formatRoute({ name: 'admin' })).toBe('#/admin');
    expect(parseRoute('#/admin')).toEqual({ name: 'admin' });
  });

  it('is asked for while it is shown, again and again, and not before or after', async () => {
    const adminLoad = vi.fn(async () => loadOf({ viewers: adminLoad.mock.calls.length }));
    const { state, stop } = begin({ adminLoad });
    await vi.advanceTimersByTimeAsync(10_000);
    expect(adminLoad).not.toHaveBeenCalled();
    await show(state);
    expect(valueOf(state.admin.value)?.load.viewers).toBe(1);
    await vi.advanceTimersByTimeAsync(3000);
    expect(valueOf(state.admin.value)?.load.viewers).toBe(2);
    state.route.value = { name: 'home' };
    await vi.advanceTimersByTimeAsync(10_000);
    expect(adminLoad).toHaveBeenCalledTimes(2);
    expect(state.admin.value.state).toBe('loading');
    stop();
  });

  it('stays while the service does not answer, and says who may not see it', async () => {
    let answer: () => Promise<ReturnType<typeof loadOf>> = async () => loadOf();
    const { state, stop } = begin({ adminLoad: () => answer() });
    await show(state);
    answer = () => Promise.reject(new ApiError(0, 'net.unreachable', 'none'));
    await vi.advanceTimersByTimeAsync(3000);
    expect(state.admin.value.state).toBe('ready');
    answer = () => Promise.reject(new ApiError(403, 'auth.scope', 'not you'));
    await vi.advanceTimersByTimeAsync(3000);
    expect(state.admin.value).toMatchObject({ state: 'failed', error: { code: 'auth.scope' } });
    state.route.value = { name: 'home' };
    stop();
  });

  it('shows at once who was locked out; what is refused is said', async () => {
    const locked = new Set<string>();
    const { state, commands, stop } = begin({
      adminAccounts: async () => [accountOf('ben', { locked: locked.has('ac_ben') })],
      lockAccount: async (id, on) => {
        if (id === 'ac_anna') throw new ApiError(409, 'auth.own_account', 'your own');
        if (on) locked.add(id);
        else locked.delete(id);
      },
    });
    await show(state);
    await commands.lock('ac_ben', true);
    expect(valueOf(state.admin.value)?.accounts[0]!.locked).toBe(true);
    await commands.lock('ac_ben', false);
    expect(valueOf(state.admin.value)?.accounts[0]!.locked).toBe(false);
    await commands.lock('ac_anna', true);
    expect(state.notices.value.map(({ code }) => code)).toEqual(['auth.own_account']);
    state.route.value = { name: 'home' };
    stop();
  });
});
