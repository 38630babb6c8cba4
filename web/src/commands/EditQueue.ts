// Changes of the pattern on their way to the service. Each is one edit of its API, or a list of them that is done as a whole;
// the page shows what comes back. Edits wait for each other, so that each one names the revision it was made for.

import type { Api } from '../api/Api';
import { ApiError } from '../api/http';
import type { Edit, Project } from '../api/types';
import { ready, valueOf, type AppState } from '../state/AppState';
import { t } from '../texts/language';
import { asApiError, notify, notifyError } from './notices';

export type EditApi = Pick<Api, 'edit' | 'turn' | 'history' | 'project'>;

export class EditQueue {
  private last_: Promise<void> = Promise.resolve();

  constructor(
    private readonly state_: AppState,
    private readonly api_: EditApi,
    private readonly refresh_: () => void,
  ) {}

  /** Sends the edits as one step. */
  send(...edits: Edit[]): Promise<void> {
    return this.queue((project) => this.api_.edit(project.id, project.revision, edits));
  }

  /** Any other change of the project, after those that are under way. */
  change(ask: (project: Project) => Promise<Project>): Promise<void> {
    return this.queue(ask);
  }

  undo(): Promise<void> {
    return this.queue((project) => this.api_.turn(project.id, project.revision, 'undo'));
  }

  redo(): Promise<void> {
    return this.queue((project) => this.api_.turn(project.id, project.revision, 'redo'));
  }

  private queue(ask: (project: Project) => Promise<Project>): Promise<void> {
    const next = this.last_.then(() => this.run(ask));
    this.last_ = next;
    return next;
  }

  private async run(ask: (project: Project) => Promise<Project>): Promise<void> {
    const project = this.state_.project.value;
    if (!project) return;
    const { busy, problem } = this.state_.editing;
    busy.value = true;
    try {
      this.took(await ask(project));
      problem.value = null;
    } catch (error) {
      await this.refused(project, asApiError(error));
    } finally {
      busy.value = false;
    }
  }

  /** Somebody else changed the project: the page takes the newest, and the hand tries again. */
  private async refused(project: Project, error: ApiError): Promise<void> {
    const { problem } = this.state_.editing;
    problem.value = error;
    if (error.code === 'edit.nothing_to_undo' || error.code === 'edit.nothing_to_redo') {
      problem.value = null;
      return notify(this.state_, { tone: 'info', text: error.detail });
    }
    if (error.unreachable) {
      problem.value = null;
      this.refresh_();
      return notifyError(this.state_, error);
    }
    if (error.status !== 412) return;
    problem.value = new ApiError(412, error.code, t.messages.changedElsewhere, '');
    try {
      this.took(await this.api_.project(project.id));
    } catch (failure) {
      notifyError(this.state_, failure);
    }
  }

  private took(project: Project): void {
    const { projects } = this.state_;
    const { document: _, ...row } = project;
    const all = valueOf(projects.value) ?? [];
    projects.value = ready(all.map((one) => (one.id === row.id ? row : one)));
    this.state_.editing.proposals.value = null;
  }

  /** Asked for whenever the project has another revision. */
  async loadHistory(projectId: string): Promise<void> {
    try {
      const history = await this.api_.history(projectId);
      if (this.state_.projectId.value === projectId) this.state_.editing.history.value = history;
    } catch {
      // Undo still works; only its name is missing.
    }
  }
}
