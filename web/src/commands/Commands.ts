// What a person can do, each as one function. Panels and keys call these; nothing else changes the state on purpose.

import type { Api, JobAction } from '../api/Api';
import { makeDressingApi, type DressingApi } from '../api/dressing';
import type { Job, Progress, StreamWord } from '../api/types';
import type { AppState, View } from '../state/AppState';
import { ready, valueOf } from '../state/AppState';
import { commandsOf, isActive } from '../state/jobs';
import type { Fix } from '../state/outcome';
import { formatRoute, type Route } from '../state/routes';
import { AdminCommands } from './AdminCommands';
import { DressingCommands } from './DressingCommands';
import { EditQueue } from './EditQueue';
import type { ImportCommands } from './ImportCommands';
import { IntakeCommands } from './IntakeCommands';
import { LiveCommands } from './LiveCommands';
import { asApiError, notify, notifyError } from './notices';
import { PatternCommands } from './PatternCommands';
import { RangeCommands } from './RangeCommands';
import { SeamCommands } from './SeamCommands';
import { SweepCommands } from './SweepCommands';
import { TextureCommands } from './TextureCommands';
import { TourCommands } from './TourCommands';
import { VersionCommands } from './VersionCommands';
import { t } from '../texts/language';

export interface Surroundings {
  /** Changes the address; the route follows from it. */
  go(hash: string, replace: boolean): void;
  /** Offers a text as a file. */
  save(name: string, text: string): void;
  newKey(): string;
  /** Loads the page as for somebody who has just come. */
  anew(): void;
  /** Looks at another drape from where this one is seen. */
  follow(jobId: string): void;
  /** Says something to the drape that is watched. */
  say(word: StreamWord): void;
}

export class Commands {
  readonly edits: EditQueue;
  readonly pattern: PatternCommands;
  readonly seams: SeamCommands;
  readonly ranges: RangeCommands;
  readonly intake: IntakeCommands;
  readonly imports: ImportCommands;
  readonly dressing: DressingCommands;
  readonly textures: TextureCommands;
  readonly sweeps: SweepCommands;
  readonly live: LiveCommands;
  readonly tours: TourCommands;
  readonly versions: VersionCommands;
  readonly admin: AdminCommands;

  constructor(
    private readonly state_: AppState,
    private readonly api_: Api,
    private readonly around_: Surroundings,
    private readonly refresh_: () => void,
    /** Opens a job's stream at once. */
    private readonly watch_: (jobId: string) => void,
    dressing: DressingApi = makeDressingApi(),
  ) {
    this.edits = new EditQueue(state_, api_, refresh_);
    this.pattern = new PatternCommands(state_, api_, this.edits);
    this.seams = new SeamCommands(state_, api_, this.edits);
    this.ranges = new RangeCommands(state_);
    this.dressing = new DressingCommands(state_, dressing, (ask) => this.edits.change(ask));
    this.sweeps = new SweepCommands(state_, api_, (route) => this.open(route), () => around_.newKey(), refresh_);
    this.textures = new TextureCommands(state_, api_, (ask) => this.edits.change(ask));
    this.versions = new VersionCommands(state_, api_, (ask) => this.edits.change(ask));
    this.admin = new AdminCommands(state_, api_);
    this.tours = new TourCommands(state_);
    this.live = new LiveCommands(state_, (word) => around_.say(word));
    this.intake = new IntakeCommands(state_, api_, {
      dressing: this.dressing,
      textures: this.textures,
      open: ({ id }) => this.open({ name: 'project', id }),
      drape: () => this.startDrape(),
      save: around_.save,
      refresh: refresh_,
    });
    this.imports = this.intake.imports;
  }

  open(route: Route, replace = false): void {
    this.around_.go(formatRoute(route), replace);
  }

  /** Whose page this is; where nobody is known, the page asks. */
  async lookWhoAsks(): Promise<void> {
    try {
      this.state_.session.value = await this.api_.session();
    } catch (error) {
      if (asApiError(error).status === 401) this.state_.shut.value = true;
    }
  }

  async logOut(): Promise<void> {
    try {
      await this.api_.logOut();
      this.around_.anew();
    } catch (error) {
      notifyError(this.state_, asApiError(error));
    }
  }

  /** Queues a drape of the shown project and shows it. */
  async startDrape(): Promise<void> {
    const { projectId, submitting } = this.state_;
    const project = projectId.value;
    if (!project || submitting.value) return;
    submitting.value = true;
    try {
      const job = await this.api_.submit(project, this.around_.newKey(), this.state_.goesOnFrom.value ?? undefined);
      this.watch_(job.id);
      this.state_.putJob(job);
      this.open({ name: 'job', id: job.id });
    } catch (error) {
      notifyError(this.state_, error);
    } finally {
      submitting.value = false;
    }
  }

  /** The edited project in place of the drape that is under way, or has just ended: the page follows to it by itself. */
  async goOn(): Promise<void> {
    const { job, project, submitting } = this.state_;
    const shown = job.value;
    const edited = shown !== null && project.value !== null && project.value.revision > shown.project_revision;
    if (!edited || submitting.value) return;
    submitting.value = true;
    try {
      const next = await this.successorOf(shown);
      this.state_.putJob(next);
      this.around_.follow(next.id);
    } catch (error) {
      notifyError(this.state_, error);
    } finally {
      submitting.value = false;
    }
    this.refresh_();
  }

  private async successorOf({ id, project_id, state }: Job): Promise<Job> {
    const key = this.around_.newKey();
    const fromItsEnd = (): Promise<Job> => this.api_.submit(project_id, key, id);
    if (!isActive(state)) return fromItsEnd();
    return this.api_.goOn(id, key).catch((error: unknown) => {
      // It may have ended while it was asked.
      if (asApiError(error).code === 'jobs.state') return fromItsEnd();
      throw error;
    });
  }

  async act(action: JobAction): Promise<void> {
    const job = this.state_.job.value;
    if (!job || !commandsOf(job.state)[action]) return;
    const before = this.state_.progress.value;
    try {
      this.took(await this.api_.act(job.id, action), before);
    } catch (error) {
      notifyError(this.state_, error);
    }
    this.refresh_();
  }

  /** Removes a drape that has ended, with its results. */
  removeJob(id: string): Promise<void> {
    const { allJobs, jobs } = this.state_;
    return this.remove(id, () => this.api_.removeJob(id), () => {
      jobs.value = ready(allJobs.value.filter((job) => job.id !== id));
    });
  }

  /** Removes a project with all its drapes. */
  removeProject(id: string): Promise<void> {
    const { projects, jobs, allJobs } = this.state_;
    return this.remove(id, () => this.api_.removeProject(id), () => {
      projects.value = ready((valueOf(projects.value) ?? []).filter((project) => project.id !== id));
      jobs.value = ready(allJobs.value.filter((job) => job.project_id !== id));
    });
  }

  /** What is gone is not shown any more: the page goes to where there is something. */
  private async remove(id: string, ask: () => Promise<void>, gone: () => void): Promise<void> {
    const { job, projectId } = this.state_;
    const project = projectId.value;
    const shown = project === id || job.value?.id === id;
    try {
      await ask();
      if (shown) this.open(project === null || project === id ? { name: 'home' } : { name: 'project', id: project });
      gone();
    } catch (error) {
      notifyError(this.state_, error);
    }
    this.refresh_();
  }

  /** Space: runs what does not run, pauses what does. */
  runOrPause(): Promise<void> {
    const job = this.state_.job.value;
    if (job && commandsOf(job.state).resume) return this.act('resume');
    if (job && commandsOf(job.state).pause) return this.act('pause');
    const { project } = this.state_;
    if (job?.state === 'failed' && project.value?.revision === job.project_revision) {
      const text = t.messages.wouldFail;
      notify(this.state_, { tone: 'info', text });
      this.state_.tab.value = 'drape';
      return Promise.resolve();
    }
    return this.startDrape();
  }

  /** Does what a drape's end asks for, and drapes again where that may be all there was to do. */
  async mend(fix: Fix): Promise<void> {
    const { project } = this.state_;
    const before = project.value?.revision;
    if (fix.kind === 'drape') return this.startDrape();
    if (this.ledTo(fix)) return;
    if (fix.kind === 'reverse') await this.edits.send({ edit: 'reverse_seam', seam: fix.seam });
    else if (fix.kind === 'time') await this.edits.send({ edit: 'set_max_time', max_time_s: fix.max_time_s });
    else await this.dressing.arrange();
    if (project.value?.revision !== before) return this.startDrape();
    const refused = this.state_.editing.problem.value ?? this.state_.dressing.placeProblem.value;
    if (refused) return notifyError(this.state_, refused);
    notify(this.state_, { tone: 'info', text: t.messages.asDraped });
  }

  /** Goes where a person mends it; whether that is all that the fix is. */
  private ledTo(fix: Fix): boolean {
    const { tab } = this.state_;
    if (fix.kind === 'place' || fix.kind === 'edit') this.select(fix.piece);
    else if (fix.kind === 'seam') this.pattern.selectSeam(fix.seam);
    else if (fix.kind === 'sew') void this.seams.propose();
    else return false;
    if (fix.kind === 'sew' && fix.piece) this.select(fix.piece);
    tab.value = fix.kind === 'place' ? 'arrange' : 'pattern';
    return true;
  }

  select(piece: string | null): void {
    this.state_.selected.value = piece;
  }

  hover(piece: string | null): void {
    this.state_.hovered.value = piece;
  }

  showView(view: View): void {
    this.state_.view.value = { view, turn: this.state_.view.value.turn + 1 };
  }

  /**
   * The answer to an action tells the state, unless the stream has told anything since it was asked for, `before` being
   * what it had told then: a step may be over before its answer comes, and the stream tells all that follows in order.
   */
  private took(job: Job, before: Progress | null): void {
    const { progress } = this.state_;
    if (progress.value && progress.value === before) progress.value = { ...progress.value, state: job.state };
    this.state_.putJob(job);
  }
}
