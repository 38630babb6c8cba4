// What the hand holds on the 2D view: the tool, what is selected within a piece, a seam that is being made, and what can be
// undone. Commands write it, views read it.

import { signal, type Signal } from '@preact/signals';
import type { Asset, Edit, EditStep, Fabric, Piece, PieceEdge, Point, SeamProposal, SeamSides } from '../api/types';
import type { ApiError } from '../api/http';
import type { Loaded } from './AppState';
import type { OwnFabric } from './fabrics';
import { jointsOf } from './outline';
import { PerProject } from './PerProject';
import { seriesOf, withSeries, type LoopPlace, type RangeDraft } from './seamRange';
import { emptyDraft, type SeamDraft } from './seamView';

/** What has to be known of a tool of the 2D view to take it; the tools themselves stand in tools/. */
export interface ToolFacts {
  readonly id: string;
  /** What is selected within a piece stays so. */
  readonly keepsPart: boolean;
}

/** Id of the tool that is held when all others have been put down. */
export const kRestingTool = 'pieces';

/** A part of the piece that is selected. */
export type Part =
  | { kind: 'edge'; piece: string; edge: string }
  | { kind: 'point'; piece: string; edge: string; point: number }
  | { kind: 'handle'; piece: string; edge: string; curve: number; handle: 1 | 2 };

export class EditingState extends PerProject {
  /** Id of the one that is held. */
  readonly tool: Signal<string> = this.perProject(kRestingTool);
  /** A tool is held, or an edge or seam is selected: somebody works on the pattern. */
  get atWork(): boolean {
    return this.tool.value !== kRestingTool || this.part.value !== null || this.seam.value !== null;
  }
  readonly part: Signal<Part | null> = this.perProject(null);
  readonly seam: Signal<string | null> = this.perProject(null);
  /** Under the pointer, on either view or in the list. */
  readonly litSeam: Signal<string | null> = this.perProject(null);
  readonly draft: Signal<SeamDraft> = this.perProject(emptyDraft);
  /** The range of an outline that is being drawn, to be sewn. */
  readonly range: Signal<RangeDraft | null> = this.perProject(null);
  /** Where a range would begin, or ends at the moment. */
  readonly place: Signal<LoopPlace | null> = this.perProject(null);
  /** The seam that is being made begins anew. */
  clearDraft(): void {
    this.draft.value = emptyDraft;
    this.range.value = null;
    this.place.value = null;
    this.problem.value = null;
  }
  readonly busy: Signal<boolean> = signal(false);
  /** The last edit that was refused, until another one is tried. */
  readonly problem: Signal<ApiError | null> = this.perProject(null);
  readonly history: Signal<EditStep[]> = this.perProject([]);
  /** All that were on the pattern since it is looked at, by their id: the history tells of some that are gone. */
  readonly seamsSeen: Signal<ReadonlyMap<string, SeamSides>> = this.perProject(new Map());
  /** Uploaded pictures, for choosing. */
  readonly images: Signal<Asset[]> = signal([]);
  /** The library; empty until it was asked for. */
  readonly fabrics: Signal<Fabric[]> = signal([]);
  /** Those that the project's document describes itself. */
  readonly ownFabrics: Signal<readonly OwnFabric[]> = this.perProject<readonly OwnFabric[]>([]);
  readonly uploading: Signal<boolean> = signal(false);
  readonly proposals: Signal<Loaded<SeamProposal[]> | null> = this.perProject(null);
  readonly chosen: Signal<ReadonlySet<string>> = signal(new Set());
  /** Under the pointer, in their list. */
  readonly litProposal: Signal<SeamProposal | null> = this.perProject<SeamProposal | null>(null);
  /** The pattern has the large place, the 3D view the small one. */
  readonly large: Signal<boolean> = signal(false);
  /** Where pieces that lie on one another are shown instead, mm, by their id; kept while the project is shown. */
  readonly offsets: Signal<ReadonlyMap<string, Point>> = this.perProject(new Map());
}

const kKeepTheShape: ReadonlySet<string> = new Set([
  'move_point',
  'move_handle',
  'insert_point',
  'delete_point',
  'straighten_edge',
  'bend_edge',
  'set_edge_length',
  'add_notch',
  'move_notch',
  'remove_notch',
  'set_fabric',
  'set_texture',
  'set_physical',
  'set_max_time',
]);

/** Whether a garment that hangs may go on hanging after the edit: its pieces are the same, sewn as before, where they were. */
export function keepsTheShape(edit: Edit): boolean {
  return kKeepTheShape.has(edit.edit);
}

/** The selected part as it is in the pieces; null when they do not have it any more. */
export function findPart(
  pieces: readonly Piece[],
  part: Part | null,
): { piece: Piece; edge: PieceEdge; at: Point | null } | null {
  if (!part) return null;
  const piece = pieces.find((one) => one.id === part.piece);
  const edge = piece?.edges.find((one) => one.id === part.edge);
  if (!piece || !edge) return null;
  if (part.kind === 'edge') return { piece, edge, at: null };
  const at = part.kind === 'point' ? jointsOf(edge)[part.point] : edge.curves[part.curve]?.[part.handle];
  return at ? { piece, edge, at } : null;
}

/** The seam that is being made, with the range that is being drawn. */
export function draftShown({ draft, range }: EditingState, pieces: readonly Piece[]): SeamDraft {
  const drawn = range.value;
  if (!drawn) return draft.value;
  return withSeries(draft.value, seriesOf(pieces.find(({ id }) => id === drawn.start.piece), drawn));
}

export const samePart = (a: Part | null, b: Part | null): boolean => JSON.stringify(a) === JSON.stringify(b);

/** A name that no piece has, from the one that is copied. */
export function freePieceId(pieces: readonly { id: string }[], from: string): string {
  const used = new Set(pieces.map((piece) => piece.id));
  let n = 2;
  while (used.has(`${from}_${n}`)) ++n;
  return `${from}_${n}`;
}
