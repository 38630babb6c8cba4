// Cuts body and cloth at the height that is asked for: at once, then at some of the frames. Asks where bust, waist and hip of
// the body are once a section is shown.

import { effect, untracked } from '@preact/signals';
import type { BodyMesh } from '../api/body';
import type { DressingApi } from '../api/dressing';
import { loading, valueOf, type AppState } from '../state/AppState';
import { joinedBody, type CutMesh } from '../state/planeCut';
import { levelsOf, sectionOf } from '../state/section';
import { FramePace } from './FramePace';
import { notifyError } from './notices';

export class SectionKeeper {
  private joined_: { body: BodyMesh; mesh: CutMesh } | null = null;
  private readonly pace_ = new FramePace(() => this.cut());
  /** Of whom the heights were asked for. */
  private asked_: { project: string; body: BodyMesh } | null = null;

  constructor(
    private readonly state_: AppState,
    private readonly api_: Pick<DressingApi, 'bodies' | 'mesh'>,
  ) {}

  start(): void {
    const { section, body, cuttable, projectId, cloth } = this.state_;
    effect(() => {
      void projectId.value;
      untracked(() => section.clear());
    });
    effect(() => {
      void section.shown.value;
      void section.height.value;
      void section.levels.value;
      void body.value;
      void cuttable.value;
      untracked(() => this.pace_.now());
    });
    effect(() => {
      const mesh = section.shown.value && cuttable.value ? valueOf(body.value ?? loading) : null;
      const project = projectId.value;
      if (mesh && project) untracked(() => void this.askLevels(project, mesh));
    });
    cloth.listen((event) => {
      if (event !== 'frame') section.cut.value = null;
      if (section.shown.value) this.pace_.soon();
    });
  }

  private cut(): void {
    const { section, cuttable, cloth } = this.state_;
    const wanted = section.shown.value && cuttable.value;
    const wish = { height: section.height.value, levels: section.levels.value };
    section.cut.value = wanted ? sectionOf(wish, this.body(), cloth) : null;
  }

  private body(): CutMesh | null {
    const body = valueOf(this.state_.body.value ?? loading);
    if (!body || body.indices.length === 0) return null;
    if (this.joined_?.body !== body) this.joined_ = { body, mesh: joinedBody(body) };
    return this.joined_.mesh;
  }

  /** The service tells them of the project's body as it is now, which may not be the one that the drape hangs on. */
  private async askLevels(project: string, body: BodyMesh): Promise<void> {
    if (this.asked_?.project === project && this.asked_.body === body) return;
    const asked = { project, body };
    this.asked_ = asked;
    this.state_.section.levels.value = [];
    try {
      const [bodies, mesh] = await Promise.all([this.api_.bodies(project), this.api_.mesh(project)]);
      if (this.asked_ === asked) this.state_.section.levels.value = levelsOf(bodies, mesh, body);
    } catch (error) {
      this.asked_ = null;
      notifyError(this.state_, error);
    }
  }
}
