// Follows what the page shows: opens the stream of the shown job, fetches its body, its report when it has ended, and the
// pieces of its project. Lets go of them when another is shown.

import { effect, untracked } from '@preact/signals';
import type { Api } from '../api/Api';
import type { ClothStream, ClothStreamHandlers } from '../api/ClothStream';
import { clothFromObj } from '../api/objCloth';
import type { Job, Progress, Report, StreamText } from '../api/types';
import { loading, ready, valueOf, type AppState, type Loaded } from '../state/AppState';
import { isActive } from '../state/jobs';
import { asApiError, notify } from './notices';

/** Points kept of the speed over time. */
const kHistory = 600;

export class Watcher {
  private readonly stops_: (() => void)[] = [];
  private piecesOf_ = '';
  /** The drape whose cloth is being fetched: every new row of it would ask for it again. */
  private clothOf_ = '';
  /** Whose result has been turned to. */
  private turnedTo_ = '';
  private moved_ = ''; // the job whose bodies moved while one looked

  constructor(
    private readonly state_: AppState,
    private readonly api_: Api,
    private readonly stream_: Pick<ClothStream, 'watch' | 'leave' | 'poke'>,
    private readonly refresh_: () => void,
    /** Takes the page's address to a drape. */
    private readonly go_: (id: string) => void = () => undefined,
  ) {}

  start(): void {
    const { job, project, projectId } = this.state_;
    this.stops_.push(
      effect(() => {
        const route = this.state_.route.value;
        // A job's route names it before the list has come: its stream need not wait.
        const id = route.name === 'job' ? route.id : (job.value?.id ?? null);
        untracked(() => this.show(id));
      }),
      effect(() => {
        const id = projectId.value;
        const revision = project.value?.revision ?? 0;
        untracked(() => void this.loadPieces(id, revision));
      }),
      effect(() => {
        const shown = job.value;
        if (shown && !isActive(shown.state)) untracked(() => void this.loadEnd(shown.id));
      }),
    );
  }

  stop(): void {
    for (const stop of this.stops_.splice(0)) stop();
    this.stream_.leave();
  }

  /** Opens a job's stream before anything on the page knows the job. */
  show(id: string | null): void {
    const state = this.state_;
    if (state.watched.value === id) return;
    state.watched.value = id;
    state.progress.value = null;
    state.history.value = [];
    state.report.value = null;
    state.seenPieces.value = null;
    state.body.value = null;
    state.cloth.clear();
    state.tab.value = id ? 'drape' : 'pattern';
    this.clothOf_ = '';
    this.turnedTo_ = '';
    if (!id) return this.stream_.leave();
    this.stream_.watch(this.api_.streamUrl(id));
    void this.loadBody(id);
    void this.loadSeen(id);
  }

  /** To the drape that goes on in place of the one that is watched: what is seen stays until its cloth comes. */
  follow(id: string): void {
    const state = this.state_;
    if (state.watched.value === id || state.watched.value === null) return;
    state.watched.value = id;
    state.progress.value = null;
    state.history.value = [];
    state.report.value = null;
    this.clothOf_ = '';
    this.stream_.watch(this.api_.streamUrl(id));
    this.go_(id);
    void this.loadBody(id, true);
    void this.loadSeen(id, true);
  }

  /** The service is back, or a body that was not there yet may be now. */
  retry(): void {
    this.stream_.poke();
    const id = this.state_.watched.value;
    if (id && this.state_.body.value?.state === 'failed') void this.loadBody(id);
    if (id && this.state_.seenPieces.value?.state === 'failed') void this.loadSeen(id);
    if (this.state_.pieces.value?.state === 'failed') this.piecesOf_ = '';
    void this.loadPieces(this.state_.projectId.value, this.state_.project.value?.revision ?? 0);
  }

  /** What the stream worker hands over. */
  handlers(): ClothStreamHandlers {
    const { cloth, stream } = this.state_;
    return {
      connection: (connection) => {
        stream.value = connection;
        if (connection.state === 'lost' || connection.state === 'refused') this.refresh_();
      },
      text: (message) => this.text(message),
      topology: (topology) => {
        cloth.setTopology(topology);
        const id = this.state_.watched.value;
        if (id && this.state_.body.value?.state !== 'ready') void this.loadBody(id);
      },
      frame: (positions, moment) => cloth.setPositions(positions, moment),
    };
  }

  private text(message: StreamText): void {
    switch (message.type) {
      case 'progress':
        return this.progress(message);
      case 'job':
        return this.greeted(message);
      case 'ended':
        return this.ended(message, message.job);
      case 'error':
        return notify(this.state_, { tone: 'bad', text: message.detail, code: message.code, where: message.where });
    }
  }

  private greeted({ type: _, ...job }: StreamText & { type: 'job' }): void {
    if (job.id !== this.state_.watched.value) return;
    this.state_.putJob(job);
    if (job.progress) this.progress(job.progress);
  }

  private progress(progress: Progress): void {
    const { history } = this.state_;
    this.state_.progress.value = progress;
    if (progress.phase === 'move') this.moved_ = this.state_.watched.value ?? '';
    const last = history.value[history.value.length - 1];
    if (progress.rms_speed === 0) return; // a phase begins: nothing has been measured yet
    if (progress.simulated_s <= (last?.t ?? 0)) {
      if (progress.simulated_s < (last?.t ?? 0)) history.value = [];
      return;
    }
    const kept = history.value.length < kHistory ? history.value : history.value.filter((_, i) => i % 2 === 0);
    history.value = [...kept, { t: progress.simulated_s, speed: progress.rms_speed }];
  }

  private ended(last: Progress, job: Job): void {
    this.state_.progress.value = last;
    if (job.id === this.state_.watched.value) {
      this.state_.putJob(job);
      if (job.reason_code === 'superseded') return this.follow(job.reason_where);
      if (this.moved_ === job.id) void this.loadBody(job.id); // it stands elsewhere now
    }
    this.refresh_();
  }

  /** `quietly`: the one that is seen stays until the other is there. */
  private async loadBody(id: string, quietly = false): Promise<void> {
    const { body, watched } = this.state_;
    if (body.value?.state === 'loading') return;
    if (!quietly) body.value = loading;
    try {
      const mesh = await this.api_.body(id);
      if (watched.value === id) body.value = ready(mesh);
    } catch (error) {
      if (watched.value === id) body.value = { state: 'failed', error: asApiError(error) };
    }
  }

  /** `quietly`: as loadBody(). */
  private async loadSeen(id: string, quietly = false): Promise<void> {
    const { seenPieces, watched } = this.state_;
    if (!quietly) seenPieces.value = loading;
    try {
      const seen = await this.api_.seenPieces(id);
      if (watched.value === id) seenPieces.value = ready(seen);
    } catch (error) {
      if (watched.value === id) seenPieces.value = { state: 'failed', error: asApiError(error) };
    }
  }

  private async loadPieces(id: string | null, revision: number): Promise<void> {
    const key = `${id} ${revision}`;
    if (key === this.piecesOf_) return;
    const { pieces, selected, projectId } = this.state_;
    const same = this.piecesOf_.startsWith(`${id} `);
    this.piecesOf_ = key;
    if (!same) selected.value = null;
    if (!id) return void (pieces.value = null);
    if (!same) pieces.value = loading;
    const newest = (): boolean => projectId.value === id && this.piecesOf_ === key;
    try {
      const loaded = await this.api_.pieces(id);
      if (newest()) this.state_.putPieces(loaded);
    } catch (error) {
      if (newest()) pieces.value = { state: 'failed', error: asApiError(error) };
    }
  }

  /** Once a drape has ended: its report, and its cloth when the stream has none to show any more. */
  private async loadEnd(id: string): Promise<void> {
    const { report, job, watched, cloth } = this.state_;
    if (watched.value !== id) return;
    const results = job.value?.results ?? {};
    if ('report.json' in results && !report.value) await this.loadReport(id);
    this.turnToResult(id);
    if ('final.obj' in results && !cloth.topology && this.clothOf_ !== id) await this.loadCloth(id);
  }

  /** Once for each drape that is watched; whoever works on the pattern meanwhile keeps the panel for that. */
  private turnToResult(id: string): void {
    const { report, job, watched, tab, editing, selected } = this.state_;
    // An answer that was on its way may have said since that the drape still runs: then the next one turns.
    const ended = watched.value === id && job.value?.state === 'succeeded' && report.value?.state === 'ready';
    if (!ended || this.turnedTo_ === id) return;
    this.turnedTo_ = id;
    if (tab.value !== 'pattern' || !(editing.atWork || selected.value)) tab.value = 'result';
  }

  private async loadReport(id: string): Promise<void> {
    const { report, watched } = this.state_;
    report.value = loading;
    const refused = (error: unknown): Loaded<Report> => ({ state: 'failed', error: asApiError(error) });
    const found = await this.api_.report(id).then<Loaded<Report>, Loaded<Report>>(ready, refused);
    // Another drape may be watched by now, whose report this is not.
    if (watched.value === id) report.value = found;
  }

  private async loadCloth(id: string): Promise<void> {
    const { cloth, watched, seenPieces } = this.state_;
    this.clothOf_ = id;
    try {
      const text = await this.api_.resultText(id, 'final.obj');
      await this.seenCame(); // they have its colours
      if (watched.value !== id || cloth.topology) return;
      const known = valueOf(seenPieces.value ?? loading)?.pieces ?? [];
      const read = clothFromObj(text, known);
      cloth.setTopology(read.topology);
      cloth.setPositions(read.positions, { epoch: 0, seq: 1, step: 0, time: 0 });
    } catch {
      // The gallery and the report still show how it ended.
    } finally {
      this.clothOf_ = '';
    }
  }

  /** Resolves once the pieces as they were draped are there, or are known not to come. */
  private async seenCame(): Promise<void> {
    const { seenPieces } = this.state_;
    if (seenPieces.value?.state !== 'loading') return;
    await new Promise<void>((done) => {
      const stop = effect(() => {
        if (seenPieces.value?.state === 'loading') return;
        done();
        queueMicrotask(() => stop());
      });
    });
  }
}
