// Sweeps: begun, followed while the address shows one, cancelled, removed.

import { effect, untracked } from '@preact/signals';
import type { SweepApi, SweepWish } from '../api/sweeps';
import { ready, valueOf, type AppState } from '../state/AppState';
import type { Route } from '../state/routes';
import { asApiError, notifyError } from './notices';

export class SweepCommands {
  constructor(
    private readonly state_: AppState,
    private readonly api_: SweepApi,
    private readonly open_: (route: Route) => void,
    private readonly newKey_: () => string,
    private readonly refresh_: () => void,
  ) {}

  /** The shown sweep is fetched anew whenever its row in the list has changed. */
  start(): () => void {
    const { route, sweeps } = this.state_;
    let before: unknown = null;
    return effect(() => {
      const now = route.value;
      const id = now.name === 'sweep' ? now.id : null;
      const row = (valueOf(sweeps.list.value) ?? []).find((one) => one.id === id) ?? id;
      if (row === before) return;
      before = row;
      untracked(() => void this.load(id));
    });
  }

  private async load(id: string | null): Promise<void> {
    const { shown } = this.state_.sweeps;
    if (id === null) return void (shown.value = null);
    if (shown.value?.state !== 'ready' || shown.value.value.id !== id) shown.value = { state: 'loading' };
    const wanted = (): boolean => this.state_.route.value.name === 'sweep' && (this.state_.route.value as { id: string }).id === id;
    try {
      const sweep = await this.api_.sweep(id);
      if (wanted()) shown.value = ready(sweep);
    } catch (error) {
      if (wanted() && shown.value?.state !== 'ready') shown.value = { state: 'failed', error: asApiError(error) };
    }
  }

  /** Of the shown project; a body that is '' is the project's own, and so is a fabric. */
  async begin(bodies: readonly string[], fabrics: readonly string[]): Promise<void> {
    const { projectId, sweeps } = this.state_;
    const project = projectId.value;
    if (!project || sweeps.busy.value) return;
    sweeps.busy.value = true;
    const asked = (names: readonly string[]): (string | Record<string, never>)[] => names.map((name) => (name === '' ? {} : name));
    try {
      const wish: SweepWish = { project_id: project, bodies: asked(bodies), fabrics: asked(fabrics) };
      const sweep = await this.api_.submitSweep(wish, this.newKey_());
      sweeps.shown.value = ready(sweep);
      sweeps.choosing.value = false;
      this.open_({ name: 'sweep', id: sweep.id });
    } catch (error) {
      notifyError(this.state_, error);
    } finally {
      sweeps.busy.value = false;
    }
    this.refresh_();
  }

  async cancel(id: string): Promise<void> {
    try {
      this.state_.sweeps.shown.value = ready(await this.api_.cancelSweep(id));
    } catch (error) {
      notifyError(this.state_, error);
    }
    this.refresh_();
  }

  async remove(id: string): Promise<void> {
    const { list } = this.state_.sweeps;
    const now = this.state_.route.value;
    try {
      await this.api_.removeSweep(id);
      if (now.name === 'sweep' && now.id === id) this.open_({ name: 'home' });
      list.value = ready((valueOf(list.value) ?? []).filter((one) => one.id !== id));
    } catch (error) {
      notifyError(this.state_, error);
    }
    this.refresh_();
  }
}
