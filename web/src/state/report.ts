// A drape's report in words. Pure.

import type { Report } from '../api/types';
import type { Texts } from '../texts/en';
import { told } from '../texts/told';
import { lengthWords, unit } from '../texts/units';
import { count, duration, millimetres, percent, seconds, speed } from './words';
import { t } from '../texts/language';

export type Verdict = 'good' | 'warn' | 'plain';

export interface ReportLine {
  label: string;
  value: string;
  sentence: string;
  verdict: Verdict;
}

/** Largest opening of a seam that still counts as closed, mm. */
const kClosed = 1;
/** Stretch at the 99th percentile beyond which a garment is tight, not draped. */
const kTight = 0.05;

/** `seamName` makes of a seam's id what a person calls it. */
export function reportLines(report: Report, seamName: (id: string) => string = (id) => id): ReportLine[] {
  return [ending(report, seamName), ...wearing(report), crossings(report), seams(report, seamName), stretch(report), rest(report), size(report)];
}

const kOpenSeam = 'open seam ';
const kOpenButton = 'open button ';

/** Why a drape stopped, which the report says in a word or two. */
export function stopText(why: string, seamName: (id: string) => string = (id) => id): string {
  if (why.startsWith(kOpenSeam)) return t.report.openSeam(seamName(why.slice(kOpenSeam.length)));
  if (why.startsWith(kOpenButton)) return t.report.openButton(why.slice(kOpenButton.length));
  return (t.report.stops as Record<string, string>)[why] ?? why;
}

function ending(report: Report, seamName: (id: string) => string): ReportLine {
  const took = t.report.took(report.steps, duration(report.wall_s));
  if (report.settled) {
    const value = t.report.settledAt(seconds(report.simulated_s, 2));
    return { label: t.report.lines.ending, value, sentence: t.report.cameToRest(took), verdict: 'good' };
  }
  const { stop_reason: why } = report;
  const value = t.report.stopped(stopText(why, seamName));
  const sentence = t.report.notAtRest(seconds(report.simulated_s, 2), took);
  return { label: t.report.lines.ending, value, sentence, verdict: 'warn' };
}

function crossings({ intersections }: Report): ReportLine {
  const { cloth_body, cloth_cloth, worst_frame, frames_checked } = intersections;
  
  if (cloth_body + cloth_cloth === 0) {
    const worst = worst_frame.cloth_body + worst_frame.cloth_cloth;
    const before =
      worst === 0
        ? t.report.norBefore(frames_checked)
        : t.report.thoughBefore(worst, worst_frame.step);
    const sentence = t.report.noneAtEnd(before);
    return { label: t.report.lines.intersections, value: t.common.noneFound, sentence, verdict: worst === 0 ? 'good' : 'warn' };
  }
  const sentence = t.report.passes(cloth_body, cloth_cloth);
  return { label: t.report.lines.intersections, value: count(cloth_body + cloth_cloth), sentence, verdict: 'warn' };
}

/** Nothing where nobody stands there to wear it. */
function wearing({ worn, findings, open_seams: open }: Report): ReportLine[] {
  if (worn === undefined) return [];
  const missing = findings
    .filter((finding) => finding.code === 'piece.left_out' && finding.severity === 'warning')
    .flatMap((finding) => finding.about.map((piece) => piece.id));
  const slit = findings.some(({ code }) => code === 'worn.slit');
  const without = [open.length > 0 ? [t.report.without.open] : [], missing, slit ? [t.report.without.slit] : []]
    .flat()
    .join(', ');
  const off = findings.filter((finding) => finding.code.startsWith('worn.')).map((finding) => told(finding.code, finding.message).text);
  const sentence = {
    yes: t.report.worn.yes,
    partly: t.report.worn.partly(without || t.report.without.part),
    no: `${off.join('; ') || t.report.worn.ended}.`,
  }[worn];
  const value = t.report.wornTitles[worn];
  return [{ label: t.report.lines.worn, value, sentence, verdict: worn === 'yes' ? 'good' : 'warn' }];
}

function seams({ seam_gap_max_mm: gap, open_seams: open }: Report, seamName: (id: string) => string): ReportLine {
  const closed = gap <= kClosed;
  const names = open.map((seam) => t.report.openBy(seamName(seam.id), millimetres(seam.gap_mm))).join('; ');
  const sentence = closed
    ? t.report.allClosed
    : names
      ? t.report.leftOpen(names)
      : t.report.widest(millimetres(gap));
  return { label: t.report.lines.seams, value: closed ? t.report.closed : millimetres(gap), sentence, verdict: closed ? 'good' : 'warn' };
}

function stretch({ strain }: Report): ReportLine {
  const warp = strain.warp.tension ?? strain.warp;
  const weft = strain.weft.tension ?? strain.weft;
  const value = t.report.stretchValue(percent(warp.p99), percent(weft.p99));
  const mean = Math.max(Math.abs(warp.mean), Math.abs(weft.mean));
  const sentence = t.report.stretchWords(percent(mean, 2));
  return { label: t.report.lines.stretch, value, sentence, verdict: Math.max(warp.p99, weft.p99) < kTight ? 'plain' : 'warn' };
}

function rest(report: Report): ReportLine {
  const sentence = t.report.fastest(speed(report.max_speed));
  return { label: t.report.lines.motion, value: t.report.rms(speed(report.rms_speed)), sentence, verdict: 'plain' };
}

function size(report: Report): ReportLine {
  const value = t.report.tall(lengthWords(100 * (report.highest_m - report.lowest_m), unit.value));
  const [high, low] = [report.highest_m, report.lowest_m].map((m) => lengthWords(100 * m, unit.value));
  const sentence = t.report.hangs(high!, low!, report.particles, report.triangles);
  return { label: t.report.lines.garment, value, sentence, verdict: 'plain' };
}

/** Result files a person may want, with what they are for; the rest by name. */
export interface Download {
  name: string;
  title: string;
  hint: string;
  bytes: number;
}

const kKnown: [name: string, file: keyof Texts['report']['files']][] = [
  ['final.glb', 'glb'],
  ['final.obj', 'obj'],
  ['rest.obj', 'rest'],
  ['body.obj', 'body'],
  ['report.json', 'report'],
  ['manifest.json', 'manifest'],
  ['maps.json', 'maps'],
  ['drape.log', 'hands'],
  ['sewn.json', 'sewn'],
];

export function downloadsOf(results: Record<string, number>): Download[] {
  const known = kKnown
    .filter(([name]) => name in results)
    .map(([name, file]) => ({ name, ...t.report.files[file], bytes: results[name]! }));
  const rest = Object.keys(results)
    .sort()
    .filter((name) => !stillOrder(name) && !isApart(name) && !kKnown.some(([other]) => other === name))
    .map((name) => ({ name, title: name, hint: '', bytes: results[name]! }));
  return [...known, ...rest];
}

const kStills = ['three-quarter.png', 'front.png', 'back.png', 'side.png', 'left.png', 'right.png'];
/** Small ones, and those that were asked for from the 3D view, which have a list of their own. */
const isApart = (name: string): boolean => /^(thumb(nail)?\.|still-)/.test(name);
const stillOrder = (name: string): number =>
  isApart(name) || !name.endsWith('.png') ? 0 : 1 + (kStills.indexOf(name) + 1 || 99);

/** The stills, the most telling first. */
export function stillsOf(results: Record<string, number>): string[] {
  return Object.keys(results)
    .filter((name) => stillOrder(name) > 0)
    .sort((a, b) => stillOrder(a) - stillOrder(b) || a.localeCompare(b));
}
