// What a person does with bodies and places. Every change is one step of the project's history and waits for those before
// it, like the edits of the pattern.

import type { Signal } from '@preact/signals';
import type {
  BodyWish,
  DressingApi,
  Finding,
  Mannequin,
  MeasureName,
  PieceWish,
  Place,
  ProjectBody,
} from '../api/dressing';
import type { ApiError } from '../api/http';
import type { Project } from '../api/types';
import { valueOf, loading, type AppState } from '../state/AppState';
import { bearerOf, freeBodyId, pieceOf, withMeasure, withoutMeasure, withPreset, type Marks } from '../state/dressing';
import { chooseUnit, type LengthUnit } from '../texts/units';
import { asApiError, notify, notifyError } from './notices';
import { t } from '../texts/language';

/** Does one change after those that are under way; the project that comes back is shown. */
export type Queue = (ask: (project: Project) => Promise<Project>) => Promise<void>;

/** Of a piece before the side of a box. */
export const kAway_mm = 50;

export class DressingCommands {
  private of_ = '';
  /** All pieces stand elsewhere: the view goes back to where it sees them all. */
  private reframe_ = false;

  constructor(
    private readonly state_: AppState,
    private readonly api_: DressingApi,
    private readonly queue_: Queue,
  ) {}

  // ---- what is shown

  /** Fetches body, places and findings of a revision; what is there of an older one stays until the newer comes. */
  async load(id: string | null, revision: number): Promise<void> {
    const key = `${id} ${revision}`;
    if (key === this.of_ || (id !== null && revision === 0)) return;
    if (!this.of_.startsWith(`${id} `)) this.state_.dressing.clear();
    this.of_ = key;
    if (!id) return;
    // The body first: it is what a slider changes, and the rest takes the service longer.
    await this.loadMesh(id, key);
    await Promise.all([this.loadTables(), this.loadFigures(id, key), this.loadStart(id, key)]);
  }

  /** What could not be fetched is asked for again. */
  retry(): void {
    const { mesh, startProblem } = this.state_.dressing;
    if (mesh.value && !startProblem.value?.unreachable) return;
    this.of_ = '';
    void this.load(this.state_.projectId.value, this.state_.project.value?.revision ?? 0);
  }

  /** Sizes, measures and what meshes may be: the same for all projects. */
  async loadTables(): Promise<void> {
    const { tables } = this.state_.dressing;
    if (tables.value) return;
    try {
      tables.value = await this.api_.tables();
    } catch {
      // What is shown needs none of them; the next look at a project, or for files, asks again.
    }
  }

  private async loadMesh(id: string, key: string): Promise<void> {
    const { dressing } = this.state_;
    try {
      const mesh = await this.api_.mesh(id);
      if (this.of_ === key) dressing.mesh.value = mesh;
    } catch (error) {
      if (this.of_ === key) dressing.problem.value = asApiError(error);
    }
  }

  private async loadFigures(id: string, key: string): Promise<void> {
    const { dressing } = this.state_;
    try {
      const bodies = await this.api_.bodies(id);
      if (this.of_ !== key) return;
      dressing.bodies.value = bodies;
      dressing.shown.value = Math.min(dressing.shown.value, Math.max(0, bodies.length - 1));
    } catch (error) {
      if (this.of_ === key) dressing.problem.value = asApiError(error);
    }
  }

  private async loadStart(id: string, key: string): Promise<void> {
    const { dressing } = this.state_;
    try {
      const start = await this.api_.start(id);
      const check = await this.api_.check(id);
      if (this.of_ !== key) return;
      dressing.start.value = start;
      dressing.check.value = check;
      dressing.finding.value = null;
      dressing.startProblem.value = null;
      if (this.reframe_) this.seeAll();
    } catch (error) {
      if (this.of_ !== key) return;
      this.reframe_ = false;
      dressing.check.value = null;
      dressing.start.value = null;
      dressing.startProblem.value = asApiError(error);
    }
  }

  // ---- bodies

  /** The body that the panel shows; a project without one gets one of this name. */
  private get body(): ProjectBody | null {
    const { bodies, shown } = this.state_.dressing;
    return bodies.value?.[shown.value] ?? null;
  }

  dress(wish: BodyWish, busy = t.messages.makingBody, body = this.body?.id ?? 'body'): Promise<void> {
    const { problem } = this.state_.dressing;
    return this.change(busy, problem, (project) => this.api_.dress(project, body, wish));
  }

  /** Takes the body that the panel shows out of the project. */
  undress(): Promise<void> {
    const { problem } = this.state_.dressing;
    const body = this.body;
    if (!body) return Promise.resolve();
    return this.change(t.messages.takingAway(body.id), problem, (project) => this.api_.undress(project, body.id));
  }

  choosePreset(preset: string): Promise<void> {
    return this.dress({ mannequin: withPreset(this.body?.mannequin ?? null, preset) });
  }

  setMeasure(measure: MeasureName, cm: number): Promise<void> {
    const mannequin = this.body?.mannequin;
    return mannequin ? this.dress({ mannequin: withMeasure(mannequin, measure, cm) }) : Promise.resolve();
  }

  freeMeasure(measure: MeasureName): Promise<void> {
    const mannequin = this.body?.mannequin;
    return mannequin ? this.dress({ mannequin: withoutMeasure(mannequin, measure) }) : Promise.resolve();
  }

  setMannequin(more: Partial<Mannequin>): Promise<void> {
    const mannequin = this.body?.mannequin;
    return mannequin ? this.dress({ mannequin: { ...mannequin, ...more } }) : Promise.resolve();
  }

  setSkinOffset(mm: number): Promise<void> {
    const body = this.body;
    const { stance } = this.state_.dressing;
    if (body?.mannequin) return this.dress({ mannequin: body.mannequin, skin_offset_mm: mm }, t.messages.settingDistance);
    const asset = stance.value?.asset ?? this.assetOf(body);
    return asset ? this.dress({ asset, skin_offset_mm: mm }, t.messages.settingDistance) : Promise.resolve();
  }

  private assetOf(body: ProjectBody | null): string | null {
    return (body?.file && this.state_.project.value?.files[body.file]) || null;
  }

  /** Uploads a mesh and puts it into the project, upright on the floor: in place of the shown body, or beside all. */
  async takeFile(name: string, bytes: Blob, beside = false): Promise<void> {
    const { dressing } = this.state_;
    const others = (dressing.bodies.value ?? []).map((body) => body.id);
    dressing.busy.value = t.messages.uploading(name);
    dressing.problem.value = null;
    try {
      const asset = await this.api_.upload(name, bytes);
      const { stance } = await this.api_.stance(asset.id);
      dressing.stance.value = { file: name, asset: asset.id, stance };
      const id = beside ? freeBodyId(name, others) : undefined;
      await this.dress({ asset: asset.id }, t.messages.measuring(name), id);
      if (beside && !dressing.problem.value) dressing.shown.value = others.length;
    } catch (error) {
      dressing.problem.value = asApiError(error);
    } finally {
      dressing.busy.value = '';
    }
  }

  // ---- landmarks

  /** The landmark of this name goes to the skin nearest to the place; the shown body gets one that nobody has. */
  mark(landmark: string, place: Place): Promise<void> {
    const { problem, bodies, shown, picking } = this.state_.dressing;
    picking.value = null;
    const body = bearerOf(bodies.value ?? [], shown.value, landmark) ?? this.body;
    if (!body) return Promise.resolve();
    return this.change(t.messages.movingLandmark, problem, (project) => this.api_.mark(project, body.id, landmark, place));
  }

  /** Puts a landmark back to where the body has it by itself, or takes away one that was added. */
  unmark(landmark: string): Promise<void> {
    const { problem } = this.state_.dressing;
    const body = this.body;
    if (!body) return Promise.resolve();
    return this.change(t.messages.puttingBack, problem, (project) => this.api_.unmark(project, body.id, landmark));
  }

  /** The next click on the body says where the landmark is; an empty name: never mind. */
  pick(landmark: string): void {
    const { picking } = this.state_.dressing;
    picking.value = landmark.trim() || null;
    if (picking.value) this.showMarks({ landmarks: true });
  }

  // ---- places

  async arrange(): Promise<void> {
    const { arrangement, placeProblem } = this.state_.dressing;
    let changed = false;
    await this.change(t.messages.arranging, placeProblem, async (project) => {
      const { arrangement: made, ...row } = await this.api_.arrange(project);
      arrangement.value = made;
      this.reframe_ = true;
      changed = row.revision !== project.revision;
      return row;
    });
    // They stood there already: nothing will be fetched, and all are to be seen all the same.
    if (this.reframe_ && !changed) this.seeAll();
  }

  /** Back from what was looked at closely. */
  private seeAll(): void {
    const { view, dressing } = this.state_;
    this.reframe_ = false;
    dressing.finding.value = null;
    view.value = { view: view.value.view, turn: view.value.turn + 1 };
  }

  place(wish: PieceWish): Promise<void> {
    const { placeProblem, partners } = this.state_.dressing;
    const whole = { ...wish, with_partner: partners.value };
    return this.change(t.messages.placing, placeProblem, (project) => this.api_.place(project, whole));
  }

  /** A piece let go over a side of a box: it comes there flat, as far away as it was told before. */
  drop(piece: string, at: Pick<PieceWish, 'part' | 'side' | 'at_mm'>): Promise<void> {
    const { check } = this.state_.dressing;
    const before = check.value?.pieces.find((one) => one.id === piece)?.by_hand;
    const { away_mm, flipped } = before ?? { away_mm: kAway_mm, flipped: false };
    this.state_.selected.value = piece;
    return this.place({ piece, ...at, away_mm, turn: 0, wrapped: false, flipped });
  }

  // ---- looks

  showMarks(more: Partial<Marks>): void {
    const { marks } = this.state_.dressing;
    marks.value = { ...marks.value, ...more };
  }

  /** Lengths are told in it, on this visit and the next. */
  takeUnit(unit: LengthUnit): void {
    chooseUnit(unit);
  }

  light(measure: string | null): void {
    this.state_.dressing.lit.value = measure;
  }

  /** Flies to what was found and lights up the piece and the seam that it names. */
  look(finding: Finding): void {
    const { dressing, editing, pieces, selected } = this.state_;
    dressing.finding.value = { finding, turn: (dressing.finding.value?.turn ?? 0) + 1 };
    const pattern = valueOf(pieces.value ?? loading);
    const known = (pattern?.pieces ?? []).map((piece) => piece.id);
    const piece = pieceOf(finding, known);
    if (piece) selected.value = piece;
    const seam = finding.about.find((concern) => concern.thing === 'seam')?.id;
    editing.seam.value = pattern?.seams.some((one) => one.id === seam) ? seam! : null;
  }

  /** A refusal stays here, in words beside what was wished; the others of the queue do not see it. */
  private async change(
    busy: string,
    problem: Signal<ApiError | null>,
    ask: (project: Project) => Promise<Project>,
  ): Promise<void> {
    const { dressing } = this.state_;
    dressing.busy.value = busy;
    problem.value = null;
    try {
      await this.queue_(async (project) => {
        try {
          return await ask(project);
        } catch (error) {
          if (!this.keeps(asApiError(error), problem)) throw error;
          return project;
        }
      });
    } catch (error) {
      notifyError(this.state_, error);
    } finally {
      dressing.busy.value = '';
    }
  }

  private keeps(error: ApiError, problem: Signal<ApiError | null>): boolean {
    if (error.unreachable || error.status === 412) return false;
    problem.value = error;
    if (error.status >= 500) notify(this.state_, { tone: 'bad', text: error.detail, code: error.code });
    return true;
  }
}
