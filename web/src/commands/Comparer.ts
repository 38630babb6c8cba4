// Fetches what two drapes came to when the address sets them side by side, and lets go of it when it names others.

import { effect, untracked, type Signal } from '@preact/signals';
import type { Api } from '../api/Api';
import type { BodyMesh } from '../api/body';
import { clothFromObj } from '../api/objCloth';
import { loadPicture, type LoadPicture } from '../api/pictures';
import type { SeenPiece, SeenPieces } from '../api/types';
import type { AppState } from '../state/AppState';
import { comparedOf, type Compared, type ComparedDrape } from '../state/comparison';
import { finishesOf } from '../state/fabrics';
import { assetsShown, looksOf, type Look } from '../state/texture';
import { asApiError } from './notices';

const kNotFound = 404;

/** What stands for something that is not there; any other error goes on. */
const unlessMissing =
  <T>(instead: T) =>
  (error: unknown): T => {
    if (asApiError(error).status === kNotFound) return instead;
    throw error;
  };

type Asked = Pick<Api, 'job' | 'project' | 'assetUrl' | 'resultText' | 'report' | 'seenPieces' | 'body'>;

export class Comparer {
  private stop_: () => void = () => undefined;

  constructor(
    private readonly state_: AppState,
    private readonly api_: Asked,
    private readonly load_: LoadPicture = loadPicture,
  ) {}

  start(): void {
    const { route, comparison } = this.state_;
    this.stop_ = effect(() => {
      const now = route.value;
      const [left, right] = now.name === 'compare' ? [now.left, now.right] : [null, null];
      untracked(() => {
        void this.show(left, comparison.left);
        void this.show(right, comparison.right);
      });
    });
  }

  stop(): void {
    this.stop_();
  }

  private async show(id: string | null, side: Signal<Compared | null>): Promise<void> {
    if (id === null) return void (side.value = null);
    if (comparedOf(side.value)?.job.id === id) return;
    const mine: Compared = { state: 'loading' };
    side.value = mine;
    let found: Compared;
    try {
      found = { state: 'ready', value: await this.load(id) };
    } catch (error) {
      found = { state: 'failed', error: asApiError(error) };
    }
    if (side.value === mine) side.value = found;
  }

  private async load(id: string): Promise<ComparedDrape> {
    const job = await this.api_.job(id);
    const [text, { pieces, fabrics }, body, report] = await Promise.all([
      this.api_.resultText(id, 'final.obj'),
      this.seenOf(id),
      this.bodyOf(id),
      'report.json' in job.results ? this.api_.report(id) : null,
    ]);
    const looks = await this.looksOn(pieces, job.project_id);
    return { job, ...clothFromObj(text, pieces), body, pieces, looks, finishes: finishesOf(pieces, fabrics), report };
  }

  /** Null where it hung without one. */
  private bodyOf(id: string): Promise<BodyMesh | null> {
    return this.api_.body(id).catch(unlessMissing(null));
  }

  /** None where they cannot be read any more: the cloth is shown in one colour. */
  private seenOf(id: string): Promise<SeenPieces> {
    return this.api_.seenPieces(id).catch(() => ({ pieces: [], fabrics: [] }));
  }

  /** Pictures whose file cannot be had any more are left out. */
  private async looksOn(pieces: readonly SeenPiece[], projectId: string): Promise<ReadonlyMap<string, Look>> {
    if (pieces.every(({ texture }) => texture === null)) return new Map();
    const project = await this.api_.project(projectId).catch(() => null);
    const loaded = assetsShown(pieces, project).map(async (asset) => {
      const picture = await this.load_(this.api_.assetUrl(asset)).catch(() => null);
      return picture ? ([[asset, picture]] as const) : [];
    });
    return looksOf(pieces, project, new Map((await Promise.all(loaded)).flat()));
  }
}
