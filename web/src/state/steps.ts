// Steps of the history in words, as a pattern maker calls what they are about. Pure.

import type { Edit, EditStep, Fabric, Piece, SeamSides } from '../api/types';
import { fabricTitle } from './fabrics';
import { edgeWords, isGivenSeam, seamWords, type Sewn } from './seamNames';
import { t } from '../texts/language';

/** What steps may be about. */
export interface Known {
  pieces: readonly Piece[];
  seams: ReadonlyMap<string, SeamSides>;
  /** Of the library, once they are there. */
  fabrics: readonly Fabric[];
}

/** With the seams that the history itself tells of. */
export function withSewn(known: Known, history: readonly EditStep[]): Known {
  const sewn = history.flatMap(({ edits }) => edits.filter((edit) => edit.edit === 'add_seam'));
  return { ...known, seams: new Map([...sewn.map((seam) => [seam.id, seam] as const), ...known.seams]) };
}

/** A step that changes lists of the document as a whole: who makes it says no more than which. */
function restoreText(edit: Edit): string {
  if ('bodies' in edit) return t.edits.change.bodies;
  if ('seams' in edit) return t.edits.change.seams;
  return 'pieces' in edit ? t.edits.change.pieces : t.edits.change.other;
}

const sewnOf = ({ pieces, seams }: Known): Sewn => ({ pieces, seams: [...seams.values()] });

/** An id that nobody gave a name says nothing of a seam that is not known any more. */
function seamOf(id: string, known: Known): string {
  const seam = known.seams.get(id);
  if (seam) return seamWords(seam, sewnOf(known));
  return isGivenSeam(id) ? '' : id;
}

function whatOf(edit: Edit, known: Known): string {
  if (edit.edit === 'add_seam') return seamWords(edit, sewnOf(known));
  const on: Record<string, unknown> = { ...edit };
  if (typeof on.seam === 'string') return seamOf(on.seam, known);
  const edge = typeof on.edge === 'string' ? edgeWords(known.pieces.find(({ id }) => id === on.piece), on.edge) : on.line;
  return [on.piece, edge].filter((word) => typeof word === 'string').join(' · ');
}

/** The fabric that all the edits change to; empty: they change to none, or not to one alone. */
function fabricOf(edits: readonly Edit[], { fabrics }: Known): string {
  const names = new Set(edits.map((edit) => (edit.edit === 'set_fabric' ? edit.fabric : '')));
  return names.size === 1 ? fabricTitle([...names][0]!, fabrics) : '';
}

/** A step of the history in a few words. */
export function stepText(edits: readonly Edit[], known: Known): string {
  const first = edits[0];
  if (!first) return t.edits.nothing;
  if (first.edit === 'restore') return restoreText(first);
  const words = (t.edits.kinds as Record<string, string>)[first.edit] ?? first.edit.replace(/_/g, ' ');
  const same = edits.every((edit) => edit.edit === first.edit);
  if (edits.length > 1 && !same) return t.edits.andMore(words, edits.length - 1);
  const what = edits.length > 1 ? '' : whatOf(first, known);
  const all = edits.length > 1 ? `${words} × ${edits.length}` : what ? `${words}, ${what}` : words;
  const fabric = fabricOf(edits, known);
  return fabric ? `${all}: ${fabric}` : all;
}

/** What Ctrl+Z and Ctrl+Shift+Z would do; null where there is nothing. */
export function turnsOf(history: readonly EditStep[], known: Known): { undo: string | null; redo: string | null } {
  const undo = history.find((step) => !step.undone);
  const undone = history.filter((step) => step.undone);
  const redo = undone[undone.length - 1];
  return { undo: undo ? stepText(undo.edits, known) : null, redo: redo ? stepText(redo.edits, known) : null };
}
