// A drape's report in words. Pure.

import type { Report } from '../api/types';
import { count, counted, duration, millimetres, percent, speed } from './words';

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

function ending(report: Report, seamName: (id: string) => string): ReportLine {
  const took = `${counted(report.steps, 'step')}, computed in ${duration(report.wall_s)}.`;
  if (report.settled) {
    const value = `Settled at ${report.simulated_s.toFixed(2)} s`;
    return { label: 'Ending', value, sentence: `The cloth came to rest after ${took}`, verdict: 'good' };
  }
  const { stop_reason: why } = report;
  const value = `Stopped: ${why.startsWith(kOpenSeam) ? kOpenSeam + seamName(why.slice(kOpenSeam.length)) : why}`;
  const sentence = `The cloth had not come to rest at ${report.simulated_s.toFixed(2)} s; ${took}`;
  return { label: 'Ending', value, sentence, verdict: 'warn' };
}

function crossings({ intersections }: Report): ReportLine {
  const { cloth_body, cloth_cloth, worst_frame, frames_checked } = intersections;
  const checked = counted(frames_checked, 'checked moment');
  if (cloth_body + cloth_cloth === 0) {
    const worst = worst_frame.cloth_body + worst_frame.cloth_cloth;
    const before =
      worst === 0
        ? `nor in any of ${checked}`
        : `though ${counted(worst, 'place')} did at step ${count(worst_frame.step)}`;
    const sentence = `No cloth passes through the body or itself at the end, ${before}.`;
    return { label: 'Intersections', value: 'None', sentence, verdict: worst === 0 ? 'good' : 'warn' };
  }
  const sentence = `Cloth passes through the body in ${counted(cloth_body, 'place')} and through itself in ${count(cloth_cloth)}.`;
  return { label: 'Intersections', value: count(cloth_body + cloth_cloth), sentence, verdict: 'warn' };
}

/** Nothing where nobody stands there to wear it. */
function wearing({ worn, findings, open_seams: open }: Report): ReportLine[] {
  if (worn === undefined) return [];
  const missing = findings
    .filter((finding) => finding.code === 'piece.left_out' && finding.severity === 'warning')
    .flatMap((finding) => finding.about.map((piece) => piece.id));
  const slit = findings.some(({ code }) => code === 'worn.slit');
  const without = [open.length > 0 ? ['what did not close'] : [], missing, slit ? ['an opening with nothing in it'] : []]
    .flat()
    .join(', ');
  const off = findings.filter((finding) => finding.code.startsWith('worn.')).map((finding) => finding.message);
  const sentence = {
    yes: 'Every opening goes around the limb that it is for.',
    partly: `It is on, but for ${without || 'a part'}.`,
    no: `${off.join('; ') || 'It did not end where it belongs'}.`,
  }[worn];
  const value = { yes: 'Yes', partly: 'In part', no: 'No' }[worn];
  return [{ label: 'Worn', value, sentence, verdict: worn === 'yes' ? 'good' : 'warn' }];
}

function seams({ seam_gap_max_mm: gap, open_seams: open }: Report, seamName: (id: string) => string): ReportLine {
  const closed = gap <= kClosed;
  const names = open.map((seam) => `${seamName(seam.id)} by ${millimetres(seam.gap_mm)}`).join('; ');
  const sentence = closed
    ? 'Every seam is closed over its whole length.'
    : names
      ? `Left open: ${names}.`
      : `The widest seam is open by ${millimetres(gap)}.`;
  return { label: 'Seams', value: closed ? 'Closed' : millimetres(gap), sentence, verdict: closed ? 'good' : 'warn' };
}

function stretch({ strain }: Report): ReportLine {
  const warp = strain.warp.tension ?? strain.warp;
  const weft = strain.weft.tension ?? strain.weft;
  const value = `${percent(warp.p99)} warp, ${percent(weft.p99)} weft`;
  const mean = Math.max(Math.abs(warp.mean), Math.abs(weft.mean));
  const sentence = `99 % of the cloth is stretched by less than this; ${percent(mean, 2)} on average.`;
  return { label: 'Stretch', value, sentence, verdict: Math.max(warp.p99, weft.p99) < kTight ? 'plain' : 'warn' };
}

function rest(report: Report): ReportLine {
  const sentence = `The fastest point moves at ${speed(report.max_speed)}.`;
  return { label: 'Motion left', value: `${speed(report.rms_speed)} rms`, sentence, verdict: 'plain' };
}

function size(report: Report): ReportLine {
  const value = `${(100 * (report.highest_m - report.lowest_m)).toFixed(1)} cm tall`;
  const low = (100 * report.lowest_m).toFixed(1);
  const sentence = `Hangs from ${(100 * report.highest_m).toFixed(1)} cm down to ${low} cm above the ground; ${count(report.particles)} particles, ${count(report.triangles)} triangles.`;
  return { label: 'Garment', value, sentence, verdict: 'plain' };
}

/** Result files a person may want, with what they are for; the rest by name. */
export interface Download {
  name: string;
  title: string;
  hint: string;
  bytes: number;
}

const kKnown: [string, string, string][] = [
  ['final.glb', 'GLB', 'Coloured model for 3D programs and the web'],
  ['final.obj', 'OBJ', 'Draped mesh, one object a piece'],
  ['rest.obj', 'Rest OBJ', 'The flat pieces with the same vertices'],
  ['body.obj', 'Body OBJ', 'The body it hangs on'],
  ['report.json', 'Report', 'Every figure of this drape as JSON'],
  ['manifest.json', 'Manifest', 'What it was made of and what came out, by hashes: toile verify drapes it again'],
  ['sewn.json', 'Sewn pairs', 'Which vertices are sewn together'],
];

export function downloadsOf(results: Record<string, number>): Download[] {
  const known = kKnown
    .filter(([name]) => name in results)
    .map(([name, title, hint]) => ({ name, title, hint, bytes: results[name]! }));
  const rest = Object.keys(results)
    .sort()
    .filter((name) => !stillOrder(name) && !isThumbnail(name) && !kKnown.some(([other]) => other === name))
    .map((name) => ({ name, title: name, hint: '', bytes: results[name]! }));
  return [...known, ...rest];
}

const kStills = ['three-quarter.png', 'front.png', 'back.png', 'side.png', 'left.png', 'right.png'];
const isThumbnail = (name: string): boolean => /^thumb(nail)?\./.test(name);
const stillOrder = (name: string): number =>
  isThumbnail(name) || !name.endsWith('.png') ? 0 : 1 + (kStills.indexOf(name) + 1 || 99);

/** The stills, the most telling first. */
export function stillsOf(results: Record<string, number>): string[] {
  return Object.keys(results)
    .filter((name) => stillOrder(name) > 0)
    .sort((a, b) => stillOrder(a) - stillOrder(b) || a.localeCompare(b));
}
