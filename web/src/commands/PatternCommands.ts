// What a hand does to the pieces of the pattern, and which of them it holds.

import type { Api } from '../api/Api';
import type { Edit, Piece, Point } from '../api/types';
import { loading, valueOf, type AppState } from '../state/AppState';
import { freePieceId, kRestingTool, type EditingState, type Part, type ToolFacts } from '../state/editing';
import { ownFabrics } from '../state/fabrics';
import { bentHandles, isStraight, nextEdge } from '../state/outline';
import { emptyDraft } from '../state/seamView';
import { t } from '../texts/language';
import type { EditQueue } from './EditQueue';
import { notify } from './notices';

export class PatternCommands {
  /** Of which project, cut of what, own fabrics were asked for. */
  private ownAsked_ = '';

  constructor(
    private readonly state_: AppState,
    private readonly api_: Pick<Api, 'fabrics' | 'project'>,
    private readonly edits_: Pick<EditQueue, 'send'>,
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
    this.ownAsked_ = '';
  }

  // ---- tools and what is selected

  takeTool({ id, keepsPart }: ToolFacts): void {
    const { editing } = this;
    if (!this.state_.projectId.value) return;
    editing.tool.value = id;
    editing.clearDraft();
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
      return this.edits_.send({ edit: 'straighten_edge', piece: part.piece, edge: part.edge, curve: part.curve });
    if (part) return;
    if (seam) return this.edits_.send({ edit: 'remove_seam', seam });
    if (piece) return this.removePiece(piece);
  }

  private async removePoint(part: Part & { kind: 'point' }): Promise<void> {
    const piece = this.pieces.find((one) => one.id === part.piece);
    const edge = piece?.edges.find((one) => one.id === part.edge);
    if (!piece || !edge) return;
    const { point } = part;
    if (point > 0 && point < edge.curves.length) {
      return this.edits_.send({ edit: 'delete_point', piece: part.piece, edge: part.edge, point });
    }
    // A corner: the two edges that meet there become one, and its point goes.
    const loop = piece.edges.filter((one) => one.loop === edge.loop);
    const before = point === 0 ? loop[(loop.indexOf(edge) + loop.length - 1) % loop.length]! : edge;
    const after = nextEdge(piece, before.id);
    if (!after || loop.length < 3) {
      return notify(this.state_, { tone: 'info', text: t.messages.twoCorners });
    }
    return this.edits_.send(
      { edit: 'join_edges', piece: part.piece, edge: before.id, next: after.id },
      { edit: 'delete_point', piece: part.piece, edge: before.id, point: before.curves.length },
    );
  }

  // ---- pieces

  /** The fabrics to choose from, and those that the project describes itself; each asked for once. */
  async loadFabrics(): Promise<void> {
    await Promise.all([this.loadLibrary(), this.loadOwnFabrics()]);
  }

  private async loadLibrary(): Promise<void> {
    const { fabrics } = this.editing;
    if (fabrics.value.length > 0) return;
    try {
      fabrics.value = await this.api_.fabrics();
    } catch {
      // The pieces keep theirs; the next look asks again.
    }
  }

  /** Pieces name a document's fabrics by ids that say little. */
  private async loadOwnFabrics(): Promise<void> {
    const id = this.state_.projectId.value;
    const asked = `${id} ${[...new Set(this.pieces.map(({ fabric }) => fabric))].join('\n')}`;
    if (!id || this.pieces.length === 0 || asked === this.ownAsked_) return;
    this.ownAsked_ = asked;
    try {
      const own = ownFabrics((await this.api_.project(id)).document);
      if (this.state_.projectId.value === id) this.editing.ownFabrics.value = own;
    } catch {
      this.ownAsked_ = ''; // the next look asks again
    }
  }

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
    await this.edits_.send(...edits);
    if (this.state_.project.value?.revision !== before)
      offsets.value = new Map([...offsets.value].map(([id]) => [id, [0, 0]]));
  }

  async renamePiece(piece: string, to: string): Promise<void> {
    const name = to.trim();
    if (name === '' || name === piece) return;
    await this.edits_.send({ edit: 'rename_piece', piece, to: name });
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
    await this.edits_.send({ edit: 'duplicate_piece', piece, id, by, mirrored });
    if (!this.editing.problem.value) this.state_.selected.value = id;
  }

  async removePiece(piece: string): Promise<void> {
    await this.edits_.send({ edit: 'delete_piece', piece });
    if (!this.editing.problem.value) this.state_.selected.value = null;
  }

  // ---- edges

  /** A straight edge or curve gets handles; a curved one becomes straight. */
  async bendOrStraighten(piece: string, edge: string): Promise<void> {
    const found = this.pieces.find((one) => one.id === piece)?.edges.find((one) => one.id === edge);
    if (!found) return;
    if (!found.curves.every(isStraight)) return this.edits_.send({ edit: 'straighten_edge', piece, edge });
    const edits = found.curves.map((curve, i): Edit => {
      const [handle1, handle2] = bentHandles(curve);
      return { edit: 'bend_edge', piece, edge, curve: i, handle1, handle2 };
    });
    return this.edits_.send(...edits);
  }

  async renameEdge(piece: string, edge: string, to: string): Promise<void> {
    await this.edits_.send({ edit: 'rename_edge', piece, edge, to });
    if (!this.editing.problem.value) this.editing.part.value = { kind: 'edge', piece, edge: to };
  }

  /** A wedge in the middle of an edge, and the seam that closes it. */
  addDart(piece: string, edge: string, width_mm: number, depth_mm: number): Promise<void> {
    return this.edits_.send({ edit: 'add_dart', piece, edge, at: 0.5, width_mm, depth_mm, id: this.dartId() });
  }

  /** A diamond within the cloth, and the seam that closes it. */
  addInnerDart(piece: string, from: Point, to: Point, width_mm: number): Promise<void> {
    return this.edits_.send({ edit: 'add_inner_dart', piece, from, to, width_mm, id: this.dartId() });
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
    return next ? this.edits_.send({ edit: 'join_edges', piece, edge, next: next.id }) : Promise.resolve();
  }
}
