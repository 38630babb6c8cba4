// Seams as a hand makes them: the one that is being made, side by side, and those that the pieces ask for.

import type { Api } from '../api/Api';
import type { Edit, SeamProposal } from '../api/types';
import { loading, ready, valueOf, type AppState } from '../state/AppState';
import type { EditingState } from '../state/editing';
import { tidied } from '../state/seamRange';
import { clash, emptyDraft, freeSeamId, ticked, toWear, withEdge, type Side } from '../state/seamView';
import type { EditQueue } from './EditQueue';
import { asApiError } from './notices';

export class SeamCommands {
  constructor(
    private readonly state_: AppState,
    private readonly api_: Pick<Api, 'proposals'>,
    private readonly edits_: Pick<EditQueue, 'send'>,
  ) {}

  private get editing(): EditingState {
    return this.state_.editing;
  }

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
    this.editing.clearDraft();
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
    await this.edits_.send({ edit: 'add_seam', id, a, b, same_direction: sameDirection });
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

  /** Lights one in both views. */
  lightProposal(proposal: SeamProposal | null): void {
    this.editing.litProposal.value = proposal;
  }

  /** Adds the ticked proposals as one step. */
  acceptProposals(): Promise<void> {
    return this.accept(({ id }) => this.editing.chosen.value.has(id));
  }

  acceptProposal(id: string): Promise<void> {
    return this.accept((one) => one.id === id);
  }

  /** Those that are still possible stay, to be looked at. */
  private async accept(isTaken: (one: SeamProposal) => boolean): Promise<void> {
    const { proposals, chosen, problem, litProposal } = this.editing;
    const project = this.state_.projectId.value;
    const found = valueOf(proposals.value ?? loading) ?? [];
    const taken = found.filter(isTaken);
    if (taken.length === 0) return;
    await this.edits_.send(...taken.map(seamOf));
    litProposal.value = null;
    if (problem.value || this.state_.projectId.value !== project) return;
    const left = found.filter((one) => !isTaken(one) && !taken.some((other) => clash(one, other)));
    proposals.value = ready(left);
    chosen.value = new Set(left.map(({ id }) => id).filter((id) => chosen.value.has(id)));
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
