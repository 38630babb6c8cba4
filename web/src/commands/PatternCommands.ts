// What a hand does to the pattern. Each change is one edit of the service's API, or a list of them that is done as a whole;
// the page shows what comes back. Edits wait for each other, so that each one names the revision it was made for.

import type { Api } from '../api/Api';
import { ApiError } from '../api/http';
import type { Edit, Piece, Point, Project, SeamProposal } from '../api/types';
import { loading, ready, valueOf, type AppState } from '../state/AppState';
import { freePieceId, kRestingTool, type EditingState, type Part, type ToolFacts } from '../state/editing';
import { bentHandles, isStraight, nextEdge } from '../state/outline';
import { tidied } from '../state/seamRange';
import { emptyDraft, freeSeamId, ticked, toWear, withEdge, type Side } from '../state/seamView';
import { asApiError, notify, notifyError } from './notices';
import { t } from '../texts/language';

export type PatternApi = Pick<Api, 'edit' | 'turn' | 'history' | 'proposals' | 'project' | 'fabrics'>;

export class PatternCommands {
  private last_: Promise<void> = Promise.resolve();

  constructor(
    private readonly state_: AppState,
    private readonly api_: PatternApi,
    private readonly refresh_: () => void,
  ) {}

  private get editing(): EditingState {
    return this.state_.editing;
  }

  private get pieces(): Piece[] {
    return valueOf(this.state_.pieces.value ?? loading)?.pieces ?? [];
  }

  /** Another project is shown: puts down everything that belonged to the last one. */
  projectChanged(): void {
    this.editing.clear();
  }

  // ---- tools and what is selected

  takeTool({ id, keepsPart }: ToolFacts): void {
    const { editing } = this;
    if (!this.state_.projectId.value) return;
    editing.tool.value = id;
    this.clearDraft();
    if (!keepsPart) editing.part.value = null;
    if (id !== kRestingTool) this.state_.tab.value = 'pattern';
  }

  selectPart(part: Part | null): void {
    const { editing } = this;
    editing.part.value = part;
    editing.seam.value = null;
    if (part) {
      this.state_.selected.value = part.piece;
      this.state_.tab.value = 'pattern';
    }
  }

  selectSeam(seam: string | null): void {
    this.editing.seam.value = seam;
    this.editing.part.value = null;
    if (seam) this.state_.tab.value = 'pattern';
  }

  /** Lights a seam in both views, and leaves open what is open. */
  pointAtSeam(seam: string | null): void {
    this.editing.seam.value = seam;
    this.editing.part.value = null;
  }

  lightSeam(seam: string | null): void {
    this.editing.litSeam.value = seam;
  }

  /** Escape: puts down the innermost thing that is held. False when there was none. */
  cancel(): boolean {
    const { draft, range, part, seam, tool, problem } = this.editing;
    if (problem.value) problem.value = null;
    else if (range.value) range.value = null;
    else if (draft.value.a.length + draft.value.b.length > 0) draft.value = emptyDraft;
    else if (part.value) part.value = null;
    else if (seam.value) seam.value = null;
    else if (tool.value !== kRestingTool) tool.value = kRestingTool;
    else return false;
    return true;
  }

  /** Delete: the point, the seam or the piece that is selected. */
  async remove(): Promise<void> {
    const part = this.editing.part.value;
    const seam = this.editing.seam.value;
    const piece = this.state_.selected.value;
    if (part?.kind === 'point') return this.removePoint(part);
    if (part?.kind === 'handle')
      return this.edit({ edit: 'straighten_edge', piece: part.piece, edge: part.edge, curve: part.curve });
    if (part) return;
    if (seam) return this.edit({ edit: 'remove_seam', seam });
    if (piece) return this.removePiece(piece);
  }

  private async removePoint(part: Part & { kind: 'point' }): Promise<void> {
    const piece = this.pieces.find((one) => one.id === part.piece);
    const edge = piece?.edges.find((one) => one.id === part.edge);
    if (!piece || !edge) return;
    const { point } = part;
    if (point > 0 && point < edge.curves.length) {
      return this.edit({ edit: 'delete_point', piece: part.piece, edge: part.edge, point });
    }
    // A corner: the two edges that meet there become one, and its point goes.
    const loop = piece.edges.filter((one) => one.loop === edge.loop);
    const before = point === 0 ? loop[(loop.indexOf(edge) + loop.length - 1) % loop.length]! : edge;
    const after = nextEdge(piece, before.id);
    if (!after || loop.length < 3) {
      return notify(this.state_, { tone: 'info', text: t.messages.twoCorners });
    }
    return this.edit(
      { edit: 'join_edges', piece: part.piece, edge: before.id, next: after.id },
      { edit: 'delete_point', piece: part.piece, edge: before.id, point: before.curves.length },
    );
  }

  // ---- edits

  /** Sends the edits as one step. */
  edit(...edits: Edit[]): Promise<void> {
    return this.queue((project) => this.api_.edit(project.id, project.revision, edits));
  }

  /** The fabrics to choose from, asked for once. */
  async loadFabrics(): Promise<void> {
    const { fabrics } = this.editing;
    if (fabrics.value.length > 0) return;
    try {
      fabrics.value = await this.api_.fabrics();
    } catch {
      // The pieces keep theirs; the next look asks again.
    }
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
    const { busy, problem } = this.editing;
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
    const { problem } = this.editing;
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
    this.editing.proposals.value = null;
  }

  /** Asked for whenever the project has another revision. */
  async loadHistory(projectId: string): Promise<void> {
    try {
      const history = await this.api_.history(projectId);
      if (this.state_.projectId.value === projectId) this.editing.history.value = history;
    } catch {
      // Undo still works; only its name is missing.
    }
  }

  // ---- pieces

  async movePiece(piece: string, by: Point): Promise<void> {
    const { offsets } = this.editing;
    const shown = [...offsets.value].filter(([, [x, y]]) => x !== 0 || y !== 0);
    // Pieces that lie on one another were shown apart: what is seen becomes what is.
    const edits: Edit[] = shown.map(([id, offset]) => ({
      edit: 'move_piece',
      piece: id,
      by: id === piece ? [offset[0] + by[0], offset[1] + by[1]] : offset,
    }));
    if (!shown.some(([id]) => id === piece)) edits.push({ edit: 'move_piece', piece, by });
    const before = this.state_.project.value?.revision;
    await this.edit(...edits);
    if (this.state_.project.value?.revision !== before)
      offsets.value = new Map([...offsets.value].map(([id]) => [id, [0, 0]]));
  }

  async renamePiece(piece: string, to: string): Promise<void> {
    const name = to.trim();
    if (name === '' || name === piece) return;
    await this.edit({ edit: 'rename_piece', piece, to: name });
    if (this.editing.problem.value) return;
    const { offsets } = this.editing;
    const offset = offsets.value.get(piece);
    if (offset) offsets.value = new Map([...offsets.value, [name, offset]]);
    this.state_.selected.value = name;
  }

  async duplicatePiece(piece: string, mirrored: boolean): Promise<void> {
    const source = this.pieces.find((one) => one.id === piece);
    if (!source) return;
    const xs = source.outline.map(([x]) => x);
    const id = freePieceId(this.pieces, piece);
    const { offsets } = this.editing;
    offsets.value = new Map([...offsets.value, [id, offsets.value.get(piece) ?? [0, 0]]]);
    const by: Point = [Math.max(...xs) - Math.min(...xs) + 40, 0];
    await this.edit({ edit: 'duplicate_piece', piece, id, by, mirrored });
    if (!this.editing.problem.value) this.state_.selected.value = id;
  }

  async removePiece(piece: string): Promise<void> {
    await this.edit({ edit: 'delete_piece', piece });
    if (!this.editing.problem.value) this.state_.selected.value = null;
  }

  // ---- edges

  /** A straight edge or curve gets handles; a curved one becomes straight. */
  async bendOrStraighten(piece: string, edge: string): Promise<void> {
    const found = this.pieces.find((one) => one.id === piece)?.edges.find((one) => one.id === edge);
    if (!found) return;
    if (!found.curves.every(isStraight)) return this.edit({ edit: 'straighten_edge', piece, edge });
    const edits = found.curves.map((curve, i): Edit => {
      const [handle1, handle2] = bentHandles(curve);
      return { edit: 'bend_edge', piece, edge, curve: i, handle1, handle2 };
    });
    return this.edit(...edits);
  }

  async renameEdge(piece: string, edge: string, to: string): Promise<void> {
    await this.edit({ edit: 'rename_edge', piece, edge, to });
    if (!this.editing.problem.value) this.editing.part.value = { kind: 'edge', piece, edge: to };
  }

  /** A wedge in the middle of an edge, and the seam that closes it. */
  addDart(piece: string, edge: string, width_mm: number, depth_mm: number): Promise<void> {
    return this.edit({ edit: 'add_dart', piece, edge, at: 0.5, width_mm, depth_mm, id: this.dartId() });
  }

  /** A diamond within the cloth, and the seam that closes it. */
  addInnerDart(piece: string, from: Point, to: Point, width_mm: number): Promise<void> {
    return this.edit({ edit: 'add_inner_dart', piece, from, to, width_mm, id: this.dartId() });
  }

  private dartId(): string {
    const used = new Set((valueOf(this.state_.pieces.value ?? loading)?.seams ?? []).map((seam) => seam.id));
    let n = 1;
    while (used.has(`dart${n}`)) ++n;
    return `dart${n}`;
  }

  joinWithNext(piece: string, edge: string): Promise<void> {
    const found = this.pieces.find((one) => one.id === piece);
    const next = found && nextEdge(found, edge);
    return next ? this.edit({ edit: 'join_edges', piece, edge, next: next.id }) : Promise.resolve();
  }

  // ---- seams

  /** A click on an edge with the sewing tool. */
  sewEdge(piece: string, edge: string): void {
    this.editing.draft.value = withEdge(this.editing.draft.value, piece, edge);
  }

  /** Enter: from side A to side B, and from there to a seam. */
  async finishSide(): Promise<void> {
    const { draft } = this.editing;
    const { a, b, side } = draft.value;
    if (side === 'a') {
      if (a.length > 0) draft.value = { ...draft.value, side: 'b' };
      return;
    }
    if (b.length > 0) await this.addSeam();
  }

  /** Sews a part of an edge only: from and to are fractions of its length. Nothing when they are none. */
  cutDraft(side: Side, index: number, from: number, to: number): void {
    const { draft } = this.editing;
    if (!(from >= 0 && to <= 1 && from < to)) return;
    const series = draft.value[side].map((use, i) => (i === index ? { ...use, from, to } : use));
    draft.value = { ...draft.value, [side]: series };
  }

  /** Takes an edge, or a part of one, out of the seam that is being made. */
  leaveOut(side: Side, index: number): void {
    const { draft } = this.editing;
    draft.value = { ...draft.value, [side]: draft.value[side].filter((_, i) => i !== index) };
  }

  /** The seam that is being made begins anew. */
  clearDraft(): void {
    const { draft, range, place } = this.editing;
    draft.value = emptyDraft;
    range.value = null;
    place.value = null;
    this.editing.problem.value = null;
  }

  turnDraft(): void {
    const { draft } = this.editing;
    draft.value = { ...draft.value, sameDirection: !draft.value.sameDirection };
  }

  async addSeam(): Promise<void> {
    const { draft, place, problem, seam } = this.editing;
    const { a, b, sameDirection } = tidied(draft.value);
    if (a.length === 0 || b.length === 0) return;
    const seams = valueOf(this.state_.pieces.value ?? loading)?.seams ?? [];
    const id = freeSeamId(seams);
    await this.edit({ edit: 'add_seam', id, a, b, same_direction: sameDirection });
    if (problem.value) return;
    draft.value = emptyDraft;
    place.value = null; // what it was as long as is sewn
    seam.value = id;
  }

  /** Asks for seams that the pieces ask for. */
  async propose(): Promise<void> {
    const id = this.state_.projectId.value;
    const { proposals, chosen } = this.editing;
    if (!id) return;
    proposals.value = loading;
    try {
      const found = await this.api_.proposals(id);
      if (this.state_.projectId.value !== id) return;
      proposals.value = ready(found);
      chosen.value = toWear(found);
    } catch (error) {
      proposals.value = { state: 'failed', error: asApiError(error) };
    }
  }

  choose(proposal: string, on: boolean): void {
    const { chosen, proposals } = this.editing;
    chosen.value = ticked(valueOf(proposals.value ?? loading) ?? [], chosen.value, proposal, on);
  }

  /** Adds the ticked proposals as one step. */
  async acceptProposals(): Promise<void> {
    const { proposals, chosen } = this.editing;
    const found = valueOf(proposals.value ?? loading) ?? [];
    const accepted = found.filter((one) => chosen.value.has(one.id));
    if (accepted.length > 0) await this.edit(...accepted.map(seamOf));
  }
}

/** A proposal as the edit that accepts it. */
const seamOf = ({ id, a, b, same_direction = false }: SeamProposal): Edit => ({
  edit: 'add_seam',
  id,
  a,
  b,
  same_direction,
});
