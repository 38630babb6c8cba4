// Versions of the project that is shown: listed, named, come back to, removed.

import { effect, untracked } from '@preact/signals';
import type { VersionApi } from '../api/versions';
import type { Project } from '../api/types';
import type { AppState } from '../state/AppState';
import type { Queue } from './DressingCommands';
import { asApiError, notifyError } from './notices';

export class VersionCommands {
  /** What the list is of: the project, its revision and its drapes. */
  private of_ = '';

  constructor(
    private readonly state_: AppState,
    private readonly api_: VersionApi,
    /** Waits for the edits under way. */
    private readonly queue_: Queue,
  ) {}

  /** Follows the project that is shown, until stopped. */
  start(): () => void {
    const { project, allJobs } = this.state_;
    return effect(() => {
      const id = project.value?.id ?? '';
      const drapes = allJobs.value.filter((job) => job.project_id === id).map((job) => job.id);
      const of = [id, project.value?.revision, ...drapes].join(' ');
      untracked(() => void this.follow(id, of));
    });
  }

  private async follow(id: string, of: string): Promise<void> {
    if (of === this.of_) return;
    if (!this.of_.startsWith(`${id} `)) this.state_.versions.clear();
    this.of_ = of;
    if (id) await this.load(id);
  }

  private async load(id: string): Promise<void> {
    const of = this.of_;
    const revision = this.state_.project.value?.revision ?? 0;
    try {
      const list = await this.api_.versions(id);
      if (this.of_ !== of) return;
      this.state_.versions.list.value = list;
      this.state_.versions.told.value = revision;
    } catch {
      // What is there of them stays; the next look asks again.
      if (this.of_ === of) this.of_ = `${id} `;
    }
  }

  /** Names the state after the edits that are under way; whether it was taken. */
  async name(name: string): Promise<boolean> {
    const { problem, busy } = this.state_.versions;
    let done = false;
    busy.value = true;
    await this.queue_(async (project) => {
      try {
        await this.api_.nameVersion(project.id, project.revision, name.trim());
        problem.value = null;
        done = true;
      } catch (error) {
        problem.value = asApiError(error);
      }
      return project;
    });
    busy.value = false;
    const id = this.state_.projectId.value;
    if (done && id) await this.load(id);
    return done;
  }

  /** An edit like others: Ctrl+Z leads back. */
  async restore(version: string): Promise<void> {
    this.state_.versions.problem.value = null;
    await this.queue_((project: Project) => this.api_.restoreVersion(project.id, project.revision, version));
  }

  async remove(version: string): Promise<void> {
    const id = this.state_.projectId.value;
    if (!id) return;
    try {
      await this.api_.removeVersion(id, version);
    } catch (error) {
      notifyError(this.state_, error);
    }
    await this.load(id);
  }
}
