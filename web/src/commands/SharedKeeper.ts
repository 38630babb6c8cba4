// Follows the drape that a share link shows: opens the link, then the stream while the drape goes on, and fetches what it
// came to once it has ended.

import type { ClothStream, ClothStreamHandlers } from '../api/ClothStream';
import type { SharedApi } from '../api/links';
import { clothFromObj } from '../api/objCloth';
import { loadPicture, type LoadPicture } from '../api/pictures';
import type { Job, SharedJob } from '../api/types';
import { loading, ready, valueOf, type AppState } from '../state/AppState';
import { isActive, kLinkedProject } from '../state/jobs';
import type { SharedState } from '../state/shared';
import { asApiError } from './notices';

export class SharedKeeper {
  private secret_ = '';
  private following_ = false;

  constructor(
    private readonly state_: AppState,
    private readonly shared_: SharedState,
    private readonly api_: SharedApi,
    private readonly stream_: Pick<ClothStream, 'watch' | 'leave'>,
    private readonly load_: LoadPicture = loadPicture,
  ) {}

  async open(secret: string): Promise<void> {
    this.secret_ = secret;
    this.shared_.job.value = loading;
    await this.taken(this.api_.open(secret));
    const job = this.seen();
    if (!job) return;
    this.state_.route.value = { name: 'job', id: job.id };
    this.state_.watched.value = job.id;
    this.state_.tab.value = 'drape';
    const body = this.loadBody(job);
    if (isActive(job.state)) this.follow(job);
    await this.loadPieces(job);
    if (!isActive(job.state)) await this.loadCloth(job);
    await body;
  }

  again(): Promise<void> {
    return this.open(this.secret_);
  }

  handlers(): ClothStreamHandlers {
    const { cloth, stream, progress } = this.state_;
    return {
      connection: (connection) => {
        stream.value = connection;
        // It may have been taken back, or the server does not know the cookie any more.
        if (connection.state === 'refused') void this.look();
        if (connection.state === 'lost' && connection.attempt > 1) void this.look();
      },
      text: (message) => {
        if (message.type === 'progress') progress.value = message;
        if (message.type === 'job') void this.look();
        if (message.type === 'ended') void this.look();
      },
      topology: (topology) => {
        cloth.setTopology(topology);
        const job = this.seen();
        if (job && this.state_.body.value?.state === 'failed') void this.loadBody(job);
      },
      frame: (positions, moment) => cloth.setPositions(positions, moment),
    };
  }

  private seen(): SharedJob | null {
    return valueOf(this.shared_.job.value);
  }

  private follow(job: SharedJob): void {
    if (this.following_) return;
    this.following_ = true;
    this.stream_.watch(this.api_.streamUrl(job.id));
  }

  /** The link's newest word. */
  private async look(): Promise<void> {
    const before = this.seen();
    if (!before) return;
    await this.taken(this.api_.show(before.id));
    const job = this.seen();
    if (job && !isActive(job.state)) await this.loadCloth(job);
  }

  /** A link that is over shows nothing any more; one whose server does not answer goes on showing what it had. */
  private async taken(asked: Promise<SharedJob>): Promise<void> {
    try {
      this.put(await asked);
    } catch (error) {
      const failure = asApiError(error);
      if (failure.unreachable && this.seen()) return;
      this.stream_.leave();
      this.following_ = false;
      this.shared_.job.value = { state: 'failed', error: failure };
    }
  }

  private put(job: SharedJob): void {
    this.shared_.job.value = ready(job);
    this.state_.progress.value = job.progress;
    this.state_.report.value = job.report ? ready(job.report) : null;
    const row: Job = { ...job, project_id: kLinkedProject };
    this.state_.jobs.value = ready([row]);
  }

  private async loadPieces(job: SharedJob): Promise<void> {
    try {
      const { pieces, fabrics } = await this.api_.pieces(job.id);
      this.state_.editing.fabrics.value = fabrics;
      this.state_.pieces.value = ready({ pieces, seams: [] });
      const images = [...new Set(pieces.flatMap(({ texture }) => (texture ? [texture.image] : [])))];
      if (images.length === 0) return;
      const files = Object.fromEntries(images.map((name) => [name, name]));
      this.state_.projects.value = ready([{ id: kLinkedProject, name: job.name, revision: 0, created_ms: 0, updated_ms: 0, files }]);
      const loaded = images.map(async (name) => [name, await this.load_(this.api_.pictureUrl(job.id, name))] as const);
      this.state_.pictures.value = new Map(await Promise.all(loaded));
    } catch {
      // The cloth is shown in its colours, or in one.
    }
  }

  private async loadBody(job: SharedJob): Promise<void> {
    this.state_.body.value = loading;
    try {
      this.state_.body.value = ready(await this.api_.body(job.id));
    } catch (error) {
      this.state_.body.value = { state: 'failed', error: asApiError(error) };
    }
  }

  /** What the stream has shown stays. */
  private async loadCloth(job: SharedJob): Promise<void> {
    const { cloth, pieces } = this.state_;
    if (!job.cloth || cloth.topology) return;
    try {
      const read = clothFromObj(await this.api_.cloth(job.id), valueOf(pieces.value ?? loading)?.pieces ?? []);
      if (cloth.topology) return;
      cloth.setTopology(read.topology);
      cloth.setPositions(read.positions, { epoch: 0, seq: 1, step: 0, time: 0 });
    } catch {
      // The pictures still show how it ended.
    }
  }
}
