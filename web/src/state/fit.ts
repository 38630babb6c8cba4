// How a worn garment fits: a row of the fit table for each girth of the report. Pure.

import type { Report } from '../api/types';
import { measureTitle } from './dressing';
import { lengthWords, type LengthUnit } from '../texts/units';
import type { Verdict } from './report';
import { t } from '../texts/language';

export interface FitRow {
  at: string;
  title: string;
  body: string;
  garment: string;
  ease: string;
  /** As the report has it. */
  fit: Girth['fit'];
  verdict: Verdict;
  /** What the row comes to: "fits", "2.1 cm too tight", "stretched". */
  word: string;
  /** What has to be known beside it; empty: nothing. */
  hint: string;
}

type Girth = NonNullable<Report['fit']>[number];

/** Girths that are taken so far from where they belong that a person should know, mm. */
const kElsewhere = 20;

const signed = (cm: number, unit: LengthUnit): string => (cm < 0 ? '−' : '+') + lengthWords(Math.abs(cm), unit);

/** "thigh_left" → "Thigh, left". */
function girthTitle(at: string): string {
  const sided = /^(.*)_(left|right)$/.exec(at);
  return sided ? `${measureTitle(sided[1]!)}, ${t.names.sides[sided[2] as 'left' | 'right']}` : measureTitle(at);
}

function word({ fit, tight_by_mm }: Girth, unit: LengthUnit): string {
  if (fit === 'too_tight') return t.report.fit.tooTight(lengthWords(tight_by_mm / 10, unit));
  return fit === 'stretched' ? t.report.fit.stretched : t.report.fit.fits;
}

function hint({ fit, shifted_mm, worn_mm }: Girth, unit: LengthUnit): string {
  const parts: string[] = [];
  if (fit === 'stretched') parts.push(t.report.fit.narrower);
  if (Math.abs(shifted_mm) > kElsewhere)
    parts.push((shifted_mm > 0 ? t.report.fit.above : t.report.fit.below)(lengthWords(Math.abs(shifted_mm) / 10, unit)));
  parts.push(t.report.fit.wornMeasures(lengthWords(worn_mm / 10, unit)));
  return parts.join(' ');
}

/** A report of an older program has no girths: no rows. */
export function fitRows({ fit }: Pick<Report, 'fit'>, unit: LengthUnit): FitRow[] {
  return (fit ?? []).map((girth) => ({
    at: girth.at,
    title: girthTitle(girth.at),
    body: lengthWords(girth.body_mm / 10, unit),
    garment: lengthWords(girth.garment_mm / 10, unit),
    ease: signed(girth.ease_mm / 10, unit),
    fit: girth.fit,
    verdict: girth.fit === 'fits' ? 'good' : girth.fit === 'stretched' ? 'plain' : 'warn',
    word: word(girth, unit),
    hint: hint(girth, unit),
  }));
}
