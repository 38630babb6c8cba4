// What a drape came to, where it is not simply done: in words, with what it is about and the ways on. Pure.

import type { Finding } from '../api/dressing';
import type { Job, Report, Seam, SeamSides } from '../api/types';
import type { Texts } from '../texts/en';
import { told } from '../texts/told';
import { sentence } from './words';
import { t } from '../texts/language';

/** Why it ended, in the reader's language where the page has words for it. */
const said = (job: Job): string => told(job.reason_code, job.reason).text;

const toldOf = ({ code, message }: Finding): string => told(code, message).text;

/** A way on that is one click. */
export type Fix =
  | { kind: 'reverse'; seam: string }
  | { kind: 'arrange' }
  | { kind: 'drape' }
  | { kind: 'place'; piece: string }
  /** `piece`: whose seams are wanting. */
  | { kind: 'sew'; piece?: string }
  | { kind: 'edit'; piece: string }
  | { kind: 'seam'; seam: string }
  /** s of simulated time. */
  | { kind: 'time'; max_time_s: number };

export interface Outcome {
  tone: 'bad' | 'warn' | 'plain';
  title: string;
  text: string;
  /** The service's own words, in English, where the text is the page's. */
  detail?: string;
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

const kTexts: [RegExp, keyof Texts['outcome']['texts']][] = [
  [/^start\.(crosses|inside)_body/, 'inBody'],
  [/^start\.(crosses_cloth|touches)/, 'inCloth'],
  [/^(stalled|drape\.stalled)/, 'stalled'],
  [/^(json|project)\./, 'project'],
  [/^dxf\./, 'dxf'],
  [/^body\./, 'body'],
  [/^seam\./, 'seam'],
  [/^arrange\.no_seams/, 'noSeams'],
  [/^(mesh|pattern)\./, 'outline'],
];

function textOf(code: string): string {
  const found = kTexts.find(([pattern]) => pattern.test(code));
  return found ? t.outcome.texts[found[1]] : '';
}

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
  const whole = sentence(`${said(job) || t.outcome.noResult}${place}`);
  // Of a start the place is lit: the words need not tell it in metres.
  const text = code.startsWith('start.') ? textOf(code) || whole : `${whole} ${textOf(code)}`.trim();
  const { detail } = told(code, job.reason);
  return { tone: 'bad', title: t.outcome.failed, text, detail, seams, pieces, fixes: fixesOf(code, pieces, seams), code };
}

function openSeams(open: Report['open_seams'], known: Known): Outcome {
  const widest = [...open].sort((a, b) => b.gap_mm - a.gap_mm);
  const seams = widest.map((seam) => seam.id).filter((id) => known.seams.includes(id));
  const [first] = seams;
  const uneven = first !== undefined && known.uneven?.includes(first) === true;
  const see: Fix[] = uneven ? [{ kind: 'seam', seam: first }] : [];
  const turn: Fix[] = first === undefined ? [] : [{ kind: 'reverse', seam: first }];
  return {
    tone: 'warn',
    title: t.outcome.openSeams(open.length),
    text: uneven ? t.outcome.openUneven : t.outcome.openWhy,
    seams,
    pieces: [],
    fixes: [...see, ...turn, { kind: 'arrange' }],
    code: 'open_seam',
  };
}

/** Of the shorter side: more is no ease that anybody sews in. */
const kMostEase = 0.15;

/** Ids of seams whose sides are not made for each other. */
export const unevenSeams = (seams: readonly Seam[]): string[] =>
  seams.filter(({ length_a_mm: a, length_b_mm: b }) => Math.abs(a - b) > kMostEase * Math.min(a, b)).map(({ id }) => id);

const idsOf = (findings: readonly Finding[], thing: 'piece' | 'seam'): string[] => [
  ...new Set(findings.flatMap(({ about }) => about.filter((one) => one.thing === thing).map(({ id }) => id))),
];

function notWorn(report: Report): Outcome | null {
  const off = report.findings.filter(({ code }) => code.startsWith('worn.') && code !== 'worn.slit');
  if (off.length === 0) return null;
  const text = sentence([...new Set(off.map(toldOf))].join('; '));
  const detail = off.map(({ code, message }) => told(code, message).detail).join('; ');
  const [seams, pieces] = [idsOf(off, 'seam'), idsOf(off, 'piece')];
  const unsewn = off.some(({ code }) => code === 'worn.unsewn');
  const fixes: Fix[] = unsewn ? [{ kind: 'sew' }] : [{ kind: 'arrange' }, { kind: 'sew' }];
  return { tone: 'warn', title: t.outcome.notWorn, text, detail, seams, pieces, fixes, code: 'worn' };
}

/** A seam may be missing there; the design may want it as well. */
function slits(report: Report): Outcome | null {
  const open = report.findings.filter(({ code }) => code === 'worn.slit');
  if (open.length === 0) return null;
  return {
    tone: 'warn',
    title: t.outcome.openings(open.length),
    text: sentence([...new Set(open.map(toldOf))].join('; ')),
    seams: [],
    pieces: idsOf(open, 'piece'),
    fixes: [{ kind: 'sew' }],
    code: 'worn.slit',
  };
}

/** Of some pieces, those that no seam leads from to any other piece. */
function looseOf(pieces: readonly string[], seams: readonly SeamSides[]): string[] {
  const loose = new Set(pieces);
  const ends = ({ a, b }: SeamSides): string[] => [...a, ...b].map(({ piece }) => piece);
  const isWay = (seam: SeamSides): boolean => ends(seam).some((id) => loose.has(id)) && ends(seam).some((id) => !loose.has(id));
  for (let way = seams.find(isWay); way; way = seams.find(isWay)) ends(way).forEach((id) => loose.delete(id));
  return [...loose];
}

function leftOut(report: Report, known: Known): Outcome | null {
  const out = report.findings.filter(({ code, severity }) => code === 'piece.left_out' && severity === 'warning');
  if (out.length === 0) return null;
  const pieces = idsOf(out, 'piece');
  const [first] = pieces;
  const loose = looseOf(pieces, known.sewn ?? []);
  const sew: Fix = loose.length === 1 ? { kind: 'sew', piece: loose[0]! } : { kind: 'sew' };
  const stand: Fix[] = [{ kind: 'arrange' }, ...(first === undefined ? [] : [{ kind: 'place', piece: first } as const])];
  return {
    tone: 'warn',
    title: t.outcome.leftOut(pieces.length),
    text: loose.length > 0 ? t.outcome.leftOutWhy : t.outcome.leftOutSewn,
    seams: [],
    pieces,
    fixes: loose.length > 0 ? [sew] : stand,
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
    title: t.outcome.moved,
    text: t.outcome.movedWhy,
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
  sewn?: readonly SeamSides[];
  /** Seams of which one side is much longer. */
  uneven?: readonly string[];
  /** s of simulated time that its drapes may take. */
  max_time_s?: number;
}

/** `since`: what was done to the project after the drape had begun, in words. */
function older(since: readonly string[]): Outcome {
  const what = since.length > 0 ? `${since.slice(0, 3).join('; ')}${since.length > 3 ? ` ${t.outcome.andMore}` : ''}.` : '';
  return {
    tone: 'warn',
    title: t.outcome.older,
    text: t.outcome.without(what),
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
    const text = sentence(said(job));
    return [{ tone: 'plain', title: t.outcome.cancelled, text, seams: [], pieces: [], fixes: [], code: '' }];
  }
  if (job.state !== 'succeeded') return [];
  const behind = since && older(since);
  if (!report) return behind ? [behind] : [];
  return [
    behind,
    report.open_seams.length > 0 ? openSeams(report.open_seams, known) : null,
    notWorn(report),
    leftOut(report, known),
    slits(report),
    job.reason_code === 'time' ? moving(known.max_time_s) : null,
  ].filter((one) => one !== null);
}

/** What the button of a fix says; `seams` are those of the pattern, which gives them their numbers. */
export const fixTitle = (fix: Fix, seams: readonly string[]): string =>
  ({
    reverse: t.outcome.fixes.reverse(fix.kind === 'reverse' ? seams.indexOf(fix.seam) + 1 : 0),
    arrange: t.outcome.fixes.arrange,
    drape: t.common.drapeAgain,
    place: t.outcome.fixes.place,
    sew: t.outcome.fixes.sew,
    edit: t.outcome.fixes.edit,
    seam: t.outcome.fixes.seam,
    time: t.outcome.fixes.time(fix.kind === 'time' ? fix.max_time_s : 0),
  })[fix.kind];
