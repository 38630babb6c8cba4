// The view of the service: fetched anew while the address shows it; accounts locked and let in again.

import { effect, untracked } from '@preact/signals';
import type { AdminApi } from '../api/admin';
import { loading, ready, type AppState } from '../state/AppState';
import { asApiError, notifyError } from './notices';

/** Between two looks, ms. */
const kLookEvery = 3000;

export class AdminCommands {
  private timer_: ReturnType<typeof setTimeout> | null = null;

  constructor(
    private readonly state_: AppState,
    private readonly api_: AdminApi,
  ) {}

  start(): () => void {
    return effect(() => {
      const shown = this.state_.route.value.name === 'admin';
      untracked(() => (shown ? void this.look() : this.leave()));
    });
  }

  private leave(): void {
    if (this.timer_) clearTimeout(this.timer_);
    this.timer_ = null;
    this.state_.admin.value = loading;
  }

  /** Once, and again after a while as long as it is shown. */
  private async look(): Promise<void> {
    if (this.timer_) clearTimeout(this.timer_);
    await this.fetch();
    if (this.state_.route.value.name === 'admin') this.timer_ = setTimeout(() => void this.look(), kLookEvery);
  }

  private async fetch(): Promise<void> {
    const { admin, route } = this.state_;
    try {
      const [load, accounts, jobs] = await Promise.all([
        this.api_.adminLoad(),
        this.api_.adminAccounts(),
        this.api_.adminJobs(),
      ]);
      if (route.value.name === 'admin') admin.value = ready({ load, accounts, jobs });
    } catch (error) {
      // What was seen last stays while the service does not answer; the banner says so.
      const known = asApiError(error);
      if (admin.value.state !== 'ready' || !known.unreachable) admin.value = { state: 'failed', error: known };
    }
  }

  async lock(account: string, locked: boolean): Promise<void> {
    try {
      await this.api_.lockAccount(account, locked);
    } catch (error) {
      notifyError(this.state_, error);
    }
    await this.fetch();
  }
}
