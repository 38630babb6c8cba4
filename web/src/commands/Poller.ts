// Keeps the lists of projects and jobs fresh, and thereby knows whether the service answers. After a failure it asks
// again with growing pauses.

import type { Signal } from '@preact/signals';
import type { Api } from '../api/Api';
import type { Job } from '../api/types';
import { ApiError } from '../api/http';
import { backoff } from '../api/JobStream';
import { ready, valueOf, type AppState, type Loaded } from '../state/AppState';
import { asApiError } from './notices';

const kBusyMs = 1000;
const kIdleMs = 4000;

export class Poller {
  private timer_: ReturnType<typeof setTimeout> | null = null;
  private running_ = false;
  private again_ = false;
  private attempt_ = 0;

  constructor(
    private readonly state_: AppState,
    private readonly api_: Pick<Api, 'projects' | 'jobs' | 'job' | 'sweeps'>,
    /** Called when the service answers again after it did not. */
    private readonly returned_: () => void,
  ) {}

  /** Asks now; while an answer is under way, once more after it. */
  async refresh(): Promise<void> {
    if (this.running_) {
      this.again_ = true;
      return;
    }
    this.running_ = true;
    if (this.timer_) clearTimeout(this.timer_);
    await this.ask();
    this.running_ = false;
    const now = this.again_;
    this.again_ = false;
    if (this.state_.shut.value) return; // nothing more comes before somebody has logged in
    this.timer_ = setTimeout(() => void this.refresh(), now ? 0 : this.pause());
  }

  stop(): void {
    if (this.timer_) clearTimeout(this.timer_);
    this.timer_ = null;
  }

  private async ask(): Promise<void> {
    try {
      const [projects, jobs, sweeps] = await Promise.all([this.api_.projects(), this.jobs(), this.api_.sweeps()]);
      const known = new Map((valueOf(this.state_.projects.value) ?? []).map((project) => [project.id, project]));
      // An edit's own answer must not be overtaken by a list that was on its way before it.
      const newest = projects.map((one) =>
        (known.get(one.id)?.revision ?? 0) > one.revision ? known.get(one.id)! : one,
      );
      take(this.state_.projects, newest);
      take(this.state_.jobs, jobs);
      take(this.state_.sweeps.list, sweeps);
      this.answered();
    } catch (error) {
      this.failed(asApiError(error));
    }
  }

  /** The newest, and the one that the address names where it is older or of a sweep. */
  private async jobs(): Promise<Job[]> {
    const jobs = await this.api_.jobs();
    const route = this.state_.route.value;
    if (route.name !== 'job' || jobs.some(({ id }) => id === route.id)) return jobs;
    try {
      return [...jobs, await this.api_.job(route.id)];
    } catch (error) {
      if (asApiError(error).status === 404) return jobs;
      throw error;
    }
  }

  private answered(): void {
    this.attempt_ = 0;
    if (this.state_.link.value.state === 'ok') return;
    this.state_.link.value = { state: 'ok' };
    this.returned_();
  }

  private failed(error: ApiError): void {
    if (error.status === 401) {
      this.state_.shut.value = true;
      return;
    }
    this.attempt_ += 1;
    if (error.unreachable) {
      const before = this.state_.link.value;
      const since = before.state === 'lost' ? before.since : Date.now();
      this.state_.link.value = { state: 'lost', since, attempt: this.attempt_, retryAt: Date.now() + this.pause() };
    }
    for (const list of [this.state_.projects, this.state_.jobs]) {
      if (list.value.state !== 'ready') list.value = { state: 'failed', error };
    }
  }

  private sweeping(): boolean {
    return (valueOf(this.state_.sweeps.list.value) ?? []).some(({ ended }) => !ended);
  }

  private pause(): number {
    if (this.attempt_ > 0) return backoff(this.attempt_, 0.5);
    return this.state_.anyActive.value || this.sweeping() ? kBusyMs : kIdleMs;
  }
}

/** Rows that are as they were stay the same objects: whatever hangs on them would be drawn anew every few seconds. */
function take<Row extends { id: string }>(list: Signal<Loaded<Row[]>>, rows: Row[]): void {
  const before = valueOf(list.value);
  const known = new Map((before ?? []).map((row) => [row.id, row]));
  const taken = rows.map((row) => {
    const old = known.get(row.id);
    return old && JSON.stringify(old) === JSON.stringify(row) ? old : row;
  });
  const same = before?.length === taken.length && taken.every((row, i) => row === before[i]);
  if (!same) list.value = ready(taken);
}
