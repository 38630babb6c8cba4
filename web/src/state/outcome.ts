// What a drape came to, where it is not simply done: in words, with what it is about and the ways on. Pure.

import type { Finding } from '../api/dressing';
import type { Job, Report } from '../api/types';
import { sentence } from './words';

/** A way on that is one click. */
export type Fix =
  | { kind: 'reverse'; seam: string }
  | { kind: 'arrange' }
  | { kind: 'drape' }
  | { kind: 'place'; piece: string }
  | { kind: 'sew' }
  | { kind: 'edit'; piece: string }
  | { kind: 'seam'; seam: string }
  /** s of simulated time. */
  | { kind: 'time'; max_time_s: number };

export interface Outcome {
  tone: 'bad' | 'warn' | 'plain';
  title: string;
  text: string;
  /** What the words are about: ids. */
  seams: string[];
  pieces: string[];
  /** The likeliest first. */
  fixes: Fix[];
  code: string;
}

/** "piece front at (0.1, 1, 0) m", "seam side": what a reason's place names. */
function named(where: string, thing: 'piece' | 'seam', known: readonly string[]): string[] {
  const rest = where.startsWith(`${thing} `) ? where.slice(thing.length + 1) : '';
  // Ids may hold spaces: the longest that fits is the one.
  const fits = known.filter((id) => rest === id || rest.startsWith(`${id} at `) || rest.startsWith(`${id},`));
  return fits.sort((a, b) => b.length - a.length).slice(0, 1);
}

const kTexts: [RegExp, string][] = [
  [/^start\.(crosses|inside)_body/, 'The piece begins within the body. Arranged anew it stands clear of it.'],
  [/^start\.(crosses_cloth|touches)/, 'Two pieces begin within each other. Arranged anew they stand apart.'],
  [/^(stalled|drape\.stalled)/, 'The seams could not be pulled shut. Nearer to each other, the pieces have less in their way.'],
  [/^(json|project)\./, 'The project itself is at fault, at the place named.'],
  [/^dxf\./, 'Export the DXF again from the pattern program, or correct the line named.'],
  [/^body\./, 'A body is one closed mesh of triangles. Another file, or a mannequin, can be chosen under Body.'],
  [/^seam\./, 'The seam joins what does not fit together: it may be turned over, or end elsewhere.'],
  [/^arrange\.no_seams/, 'Nothing says how its pieces are sewn. Seams can be looked for, or clicked together with N.'],
  [/^(mesh|pattern)\./, 'The outline of the piece wants correcting.'],
];

const textOf = (code: string): string => kTexts.find(([pattern]) => pattern.test(code))?.[1] ?? '';

/** A seam that is sewn the wrong way round, and one whose edges do not fit each other. */
const kTurned = /^seam\.(twisted|thread_)/;

function fixesOf(code: string, pieces: readonly string[], seams: readonly string[]): Fix[] {
  const [piece] = pieces;
  const [seam] = seams;
  if (code.startsWith('seam.') && seam !== undefined) {
    const [turn, see]: Fix[] = [{ kind: 'reverse', seam }, { kind: 'seam', seam }];
    return kTurned.test(code) ? [turn!, see!] : [see!, turn!];
  }
  if (code === 'arrange.no_seams') return [{ kind: 'sew' }];
  if (/^(start|placement)\.|stalled/.test(code)) {
    return [{ kind: 'arrange' }, ...(piece ? [{ kind: 'place', piece } as const] : [])];
  }
  return /^(mesh|pattern)\./.test(code) && piece ? [{ kind: 'edit', piece }] : [];
}

function failed(job: Job, known: Known): Outcome {
  const code = job.reason_code;
  const pieces = named(job.reason_where, 'piece', known.pieces);
  const seams = named(job.reason_where, 'seam', known.seams);
  const place = pieces.length + seams.length > 0 || !job.reason_where ? '' : ` (${job.reason_where})`;
  const said = sentence(`${job.reason || 'it ended without a result'}${place}`);
  // Of a start the place is lit: the words need not tell it in metres.
  const text = code.startsWith('start.') ? textOf(code) || said : `${said} ${textOf(code)}`.trim();
  return { tone: 'bad', title: 'The drape failed', text, seams, pieces, fixes: fixesOf(code, pieces, seams), code };
}

function openSeams(open: Report['open_seams'], known: Known): Outcome {
  const widest = [...open].sort((a, b) => b.gap_mm - a.gap_mm);
  const seams = widest.map((seam) => seam.id).filter((id) => known.seams.includes(id));
  const one = open.length === 1;
  return {
    tone: 'warn',
    title: one ? 'A seam stayed open' : `${open.length} seams stayed open`,
    text: 'Most often a seam is then sewn the wrong way round, or the body stands between its sides.',
    seams,
    pieces: [],
    fixes: [...seams.slice(0, 1).map((seam): Fix => ({ kind: 'reverse', seam })), { kind: 'arrange' }],
    code: 'open_seam',
  };
}

const idsOf = (findings: readonly Finding[], thing: 'piece' | 'seam'): string[] => [
  ...new Set(findings.flatMap(({ about }) => about.filter((one) => one.thing === thing).map(({ id }) => id))),
];

function notWorn(report: Report): Outcome | null {
  const off = report.findings.filter(({ code }) => code.startsWith('worn.') && code !== 'worn.slit');
  if (off.length === 0) return null;
  const text = sentence(off.map((finding) => finding.message).join('; '));
  const [seams, pieces] = [idsOf(off, 'seam'), idsOf(off, 'piece')];
  return { tone: 'warn', title: 'It is not worn as it should be', text, seams, pieces, fixes: [{ kind: 'arrange' }], code: 'worn' };
}

/** A seam may be missing there; the design may want it as well. */
function slits(report: Report): Outcome | null {
  const open = report.findings.filter(({ code }) => code === 'worn.slit');
  if (open.length === 0) return null;
  return {
    tone: 'warn',
    title: open.length === 1 ? 'An opening is left' : `${open.length} openings are left`,
    text: sentence([...new Set(open.map((finding) => finding.message))].join('; ')),
    seams: [],
    pieces: idsOf(open, 'piece'),
    fixes: [{ kind: 'sew' }],
    code: 'worn.slit',
  };
}

function leftOut(report: Report): Outcome | null {
  const out = report.findings.filter(({ code, severity }) => code === 'piece.left_out' && severity === 'warning');
  if (out.length === 0) return null;
  const pieces = idsOf(out, 'piece');
  return {
    tone: 'warn',
    title: pieces.length === 1 ? 'A piece was left out' : `${pieces.length} pieces were left out`,
    text: 'Nothing holds them to the rest, or the garment could not be put on with them, so it was draped without them.',
    seams: [],
    pieces,
    fixes: [{ kind: 'sew' }],
    code: 'piece.left_out',
  };
}

/** The document takes no more, s. */
const kMostTime = 3600;

/** `max_time_s`: of the project as it is now; undefined: not known. */
function moving(max_time_s: number | undefined): Outcome {
  const twice = Math.min(kMostTime, 2 * (max_time_s ?? 0));
  return {
    tone: 'warn',
    title: 'It still moved at the end',
    text: 'Its time was up before it came to rest. What is seen is its last moment; wide and light cloth takes longest.',
    seams: [],
    pieces: [],
    fixes: max_time_s !== undefined && twice > max_time_s ? [{ kind: 'time', max_time_s: twice }] : [],
    code: 'time',
  };
}

/** Ids that the pattern has now. */
export interface Known {
  pieces: readonly string[];
  seams: readonly string[];
  /** s of simulated time that its drapes may take. */
  max_time_s?: number;
}

/** `since`: what was done to the project after the drape had begun, in words. */
function older(since: readonly string[]): Outcome {
  const what = since.length > 0 ? ` ${since.slice(0, 3).join('; ')}${since.length > 3 ? ' and more' : ''}.` : '';
  return {
    tone: 'warn',
    title: 'Changed since this drape',
    text: `${what} Cloth, figures and files here are without it.`.trim(),
    seams: [],
    pieces: [],
    fixes: [{ kind: 'drape' }],
    code: 'older',
  };
}

/**
 * All that there is to say, gravest first; nothing of a drape that is under way or well. `since` is what was changed after
 * it had begun; null: nothing.
 */
export function outcomesOf(
  job: Job,
  report: Report | null,
  known: Known,
  since: readonly string[] | null = null,
): Outcome[] {
  if (job.state === 'failed') return [failed(job, known)];
  if (job.state === 'cancelled') {
    const text = sentence(job.reason);
    return [{ tone: 'plain', title: 'The drape was cancelled', text, seams: [], pieces: [], fixes: [], code: '' }];
  }
  if (job.state !== 'succeeded') return [];
  const behind = since && older(since);
  if (!report) return behind ? [behind] : [];
  return [
    behind,
    report.open_seams.length > 0 ? openSeams(report.open_seams, known) : null,
    notWorn(report),
    leftOut(report),
    slits(report),
    job.reason_code === 'time' ? moving(known.max_time_s) : null,
  ].filter((one) => one !== null);
}

/** What the button of a fix says; `seams` are those of the pattern, which gives them their numbers. */
export const fixTitle = (fix: Fix, seams: readonly string[]): string =>
  ({
    reverse: `Turn seam ${fix.kind === 'reverse' ? seams.indexOf(fix.seam) + 1 : ''} over and drape`,
    arrange: 'Arrange anew and drape',
    drape: 'Drape again',
    place: 'Place it by hand',
    sew: 'Look for its seams',
    edit: 'See its outline',
    seam: 'See the seam',
    time: `Give it ${fix.kind === 'time' ? fix.max_time_s : ''} s and drape`,
  })[fix.kind];
