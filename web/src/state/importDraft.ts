// A pattern file that is being made a project: what the service read, and what a person chose. Pure.

import type { ApiError } from '../api/http';
import type {
  Asset,
  Import,
  ImportedEntity,
  ImportedPiece,
  ImportWarning,
  Layer,
  LayerMap,
  Piece,
  Point,
  SeamProposal,
  Unit,
} from '../api/types';
import type { GivenFile, LoosePattern } from './intake';
import type { Loaded } from './AppState';
import { isObject, listOf } from './documents';
import { stem } from './words';
import { count as countOf } from '../texts/numbers';
import { t } from '../texts/language';
import { asRead } from '../texts/told';

export type BodyChoice =
  | { kind: 'mannequin'; preset: string }
  | { kind: 'asset'; id: string; name: string }
  | { kind: 'file'; file: GivenFile };

export interface ImportDraft {
  source: LoosePattern;
  /** Id of the uploaded pattern. */
  asset: string;
  report: Loaded<Import>;
  /** As overruled; empty: by the evidence. */
  unit: Unit | '';
  /** As chosen; empty: the file's sample size. */
  size: string;
  /** What a person says of the file's layers, by their names. */
  layers: LayerMap;
  /** The layers of a file that could not be read: what they are may be why. */
  fileLayers: Layer[];
  /** It is read again, and what is shown is of before. */
  rereading: boolean;
  /** Pieces, by their name in the file, that stay away. */
  left: ReadonlySet<string>;
  /** Proposals that are accepted. */
  chosen: ReadonlySet<string>;
  body: BodyChoice;
  /** A person chose the body: what the file says of its size counts no more. */
  bodyTaken: boolean;
  name: string;
  /** Bodies that the service has. */
  bodies: Asset[];
  presets: { id: string }[];
  error: ApiError | null;
}

/** What a view of the file's pieces is given. */
export interface PreviewProps {
  draft: ImportDraft;
  report: Import;
  /** The seam that is pointed at. */
  lit: string | null;
  onLight(seam: string | null): void;
  /** The piece that is pointed at, by its name in the file. */
  piece: string | null;
  onPiece(piece: string | null): void;
}

/** For each piece of the document, in order, the piece of the file that it comes from. */
export function sourceNames(report: Import): Map<string, string> {
  const names = new Set(report.pieces.map((piece) => piece.name));
  const sources = new Map<string, string>();
  let last = '';
  for (const piece of listOf(report.document?.pieces)) {
    const id = String(piece.id);
    const from = isObject(piece.from) ? String(piece.from.piece) : names.has(id) ? id : last;
    last = from;
    sources.set(id, from);
  }
  return sources;
}

/** Proposals whose pieces all stay. */
export function seamsInReach(report: Import, left: ReadonlySet<string>): SeamProposal[] {
  const sources = sourceNames(report);
  const stays = ({ piece }: { piece: string }): boolean => !left.has(sources.get(piece) ?? piece);
  return report.seams.filter((seam) => seam.a.every(stays) && seam.b.every(stays));
}

/** Female bodies where nothing says for whom it is: most size tables with such numbers are theirs. */
const kLetters: Record<'eu' | 'm', Record<string, number>> = {
  eu: { xs: 34, s: 36, m: 38, l: 42, xl: 44, xxl: 48 },
  m: { xs: 44, s: 46, m: 50, l: 52, xl: 54, xxl: 56 },
};

/** What a project of this file is called: GarmentCode ends the names of its files alike. */
export const projectNameOf = (file: string): string => stem(file).replace(/(.)_specification$/, '$1');

/** The table's size that a file names, in its name before its own "sample size"; empty: it names none of the table. */
export function presetNamed(report: Import, presets: readonly { id: string }[]): string {
  // "aMaleAdult38" is three words and a number.
  const words = (text: string): string[] =>
    (text.match(/[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+/g) ?? []).map((one) => one.toLowerCase());
  const name = words(stem(report.file));
  const size = words(report.size || report.sample_size);
  const says = (...some: string[]): boolean => some.some((one) => [...name, ...size].includes(one));
  const female = says('female', 'women', 'woman', 'womens', 'ladies', 'damen');
  const table = !female && says('male', 'men', 'man', 'mens', 'herren') ? 'm' : 'eu';
  const known = (size: number | string): string => presets.find(({ id }) => id === `${table}${size}`)?.id ?? '';
  const numbers = [...name, ...size].map((word) => known(/^\d\d$/.test(word) ? word : ''));
  const letter = size.map((word) => kLetters[table][word] ?? 0).find((one) => one > 0);
  return numbers.find((one) => one !== '') ?? (letter ? known(letter) : '');
}

/** The document that makes the project, with the file names that it uses. */
export function documentOf(
  draft: ImportDraft,
  report: Import,
  bodyFile: string | null,
): Record<string, unknown> | null {
  if (!report.document) return null;
  const sources = sourceNames(report);
  const pieces = listOf(report.document.pieces).filter((piece) => !draft.left.has(sources.get(String(piece.id)) ?? ''));
  if (pieces.length === 0) return null;
  const seams = seamsInReach(report, draft.left)
    .filter((seam) => draft.chosen.has(seam.id))
    .map(({ id, a, b, same_direction }) => ({ id, a, b, same_direction: same_direction ?? false }));
  const mannequin = draft.body.kind === 'mannequin' && draft.body.preset ? { preset: draft.body.preset } : {};
  const body = bodyFile ? { id: 'body', file: bodyFile } : { id: 'body', mannequin };
  return { ...report.document, name: draft.name.trim() || stem(report.file), pieces, seams, bodies: [body] };
}

/** Whether the document's pieces name the pattern file: those of a specification stand in the document itself. */
export const namesPattern = (document: Record<string, unknown>): boolean =>
  listOf(document.pieces).some((piece) => isObject(piece.from));

/** A piece of the file as the 2D view draws pieces. */
export function pictureOf(piece: ImportedPiece): Piece {
  const radians = ((piece.grain_deg ?? 90) * Math.PI) / 180;
  return {
    id: piece.name,
    outline: piece.points,
    holes: piece.hole_points,
    grain: piece.grain_deg === null ? null : [Math.cos(radians), Math.sin(radians)],
    fabric: '',
    colour: [0.55, 0.62, 0.72],
    edges: (piece.edge_list ?? []).map(({ id, length_mm, points }) => ({ id, length_mm, points, curves: [], loop: 0 })),
    notches: (piece.notch_list ?? []).map(({ at, depth_mm, angle_deg }) => {
      const turn = ((angle_deg ?? 0) * Math.PI) / 180;
      return { at, depth_mm, inwards: angle_deg === null ? null : [Math.cos(turn), Math.sin(turn)] };
    }),
    texture: null,
    lines: (piece.line_list ?? []).map((line) => ({ ...line, drawn: true })),
  };
}

/** The other half of a pair, as the service turns a piece over: about x = 0, so that its outline runs the other way. */
function turnedOver(piece: Piece, id: string): Piece {
  const over = ([x, y]: Point): Point => [-x, y];
  const back = (points: readonly Point[]): Point[] => points.map(over).reverse();
  return {
    ...piece,
    id,
    outline: back(piece.outline),
    holes: piece.holes.map(back),
    grain: piece.grain && over(piece.grain),
    edges: piece.edges.map((edge) => ({ ...edge, points: back(edge.points) })).reverse(),
    notches: piece.notches.map((notch) => ({ ...notch, at: over(notch.at), inwards: notch.inwards && over(notch.inwards) })),
    lines: piece.lines.map((line) => ({ ...line, points: line.points.map(over) })),
  };
}

/** Each piece that is sewn, halves of pairs both, and those of the file that cannot be. */
export function piecesDrawn(report: Import): Piece[] {
  const byName = new Map(report.pieces.map((piece) => [piece.name, piece]));
  const sources = sourceNames(report);
  const isDrawing = report.document !== null && namesPattern(report.document);
  const drawn = listOf(report.document?.pieces).flatMap((piece): Piece[] => {
    const id = String(piece.id);
    const source = byName.get(sources.get(id) ?? '');
    if (!source) return [];
    const picture = pictureOf(source);
    // What a document draws by itself, though it comes from a file, is the other half.
    return [isDrawing && !isObject(piece.from) ? turnedOver(picture, id) : { ...picture, id }];
  });
  const names = new Set(sources.values());
  const others = report.pieces.filter((piece) => !names.has(piece.name)).map(pictureOf);
  return [...drawn, ...others].filter((piece) => piece.outline.length > 2);
}

/** How sure the unit is, in a word. */
export const sureness = (confidence: number): string =>
  confidence >= 0.9 ? t.imports.sure : confidence >= 0.6 ? t.imports.likely : t.imports.guess;

export interface CountShare {
  fate: ImportedEntity['fate'];
  count: number;
}

export interface Accounts {
  shares: CountShare[];
  entities: number;
  /** "1,234 records: 1,000 vertices, 200 entities, 34 of structure". */
  sum: string;
  /** Whether the parts sum to the file. */
  whole: boolean;
}


/** The report's counts, added up. */
export function accountsOf(report: Import['report']): Accounts {
  const of = (fate: ImportedEntity['fate']): number =>
    report.entities.filter((group) => group.fate === fate).reduce((sum, group) => sum + group.count, 0);
  const shares = (['kept', 'converted', 'dropped'] as const).map((fate) => ({ fate, count: of(fate) }));
  const entities = shares.reduce((sum, share) => sum + share.count, 0);
  const { counts } = report;
  if (counts.records === undefined) {
    const words: Readonly<Record<string, (n: number) => string>> = t.imports.ofSpecification;
    const parts = Object.entries(counts).map(([name, count]) => words[name]?.(count) ?? `${countOf(count)} ${name}`);
    return { shares, entities, sum: parts.join(', '), whole: true };
  }
  const { records = 0, vertices = 0, structure = 0, elsewhere = 0 } = counts;
  const parts = [
    [entities, 'entities'],
    [vertices, 'vertices'],
    [structure, 'structure'],
    [elsewhere, 'elsewhere'],
  ] as const;
  const text = parts.filter(([count]) => count > 0).map(([count, name]) => `${countOf(count)} ${t.imports.ofRecords[name]}`);
  return {
    shares,
    entities,
    sum: t.imports.records(records, text.join(', ')),
    whole: records === entities + vertices + structure + elsewhere && entities === counts.entities,
  };
}

export interface ReportFilter {
  fate: ImportedEntity['fate'] | '';
  piece: string;
  text: string;
}

const has = (text: string, ...fields: string[]): boolean =>
  text === '' || fields.some((field) => field.toLowerCase().includes(text.toLowerCase()));

export const entitiesShown = (entities: readonly ImportedEntity[], filter: ReportFilter): ImportedEntity[] =>
  entities.filter(
    (one) =>
      (filter.fate === '' || one.fate === filter.fate) &&
      (filter.piece === '' || one.piece === filter.piece) &&
      has(filter.text, asRead(one.type), one.layer, one.block, asRead(one.reason), one.piece),
  );

export const warningsShown = (warnings: readonly ImportWarning[], filter: ReportFilter): ImportWarning[] =>
  warnings.filter(
    (one) =>
      (filter.piece === '' || one.piece === filter.piece) && has(filter.text, asRead(one.text), one.piece, String(one.line)),
  );

/** "lines 12, 48, 60 and 9 more". */
export function linesText(lines: readonly number[], most = 4): string {
  const known = lines.filter((line) => line > 0);
  if (known.length === 0) return '';
  const shown = known.slice(0, most).join(', ');
  return t.imports.lines(known.length, shown, known.length - most);
}
