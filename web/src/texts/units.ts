// Lengths in the unit that was chosen. Everything is kept in metric units; these stand between it and what is read and typed.

import { signal, type Signal } from '@preact/signals';
import { keep, kept } from './kept';
import { count, fixed } from './numbers';

/** mm: the pattern in millimetres and the body in centimetres, as tailors do; cm and inch: both in that. */
export type LengthUnit = 'mm' | 'cm' | 'inch';

export const lengthUnits: readonly LengthUnit[] = ['mm', 'cm', 'inch'];

const first = (): LengthUnit => lengthUnits.find((unit) => unit === kept('lengths')) ?? 'mm';

export const unit: Signal<LengthUnit> = signal(first());

/** What a person chose, which the browser keeps. */
export function chooseUnit(next: LengthUnit): void {
  unit.value = next;
  keep('lengths', next);
}

const kMmPerInch = 25.4;

// ---- on the pattern

const kPatternUnits: Record<LengthUnit, { mm: number; sign: string; finer: number }> = {
  mm: { mm: 1, sign: 'mm', finer: 0 },
  cm: { mm: 10, sign: 'cm', finer: 1 },
  inch: { mm: kMmPerInch, sign: 'in', finer: 2 },
};

export const patternSign = (): string => kPatternUnits[unit.value].sign;

/** A length of the pattern as it is shown, and back, mm. */
export const shownMm = (mm: number): number => mm / kPatternUnits[unit.value].mm;
export const mmOf = (shown: number): number => shown * kPatternUnits[unit.value].mm;

/** Digits that are as fine as so many of millimetres. */
export const patternDigits = (digits: number): number => digits + kPatternUnits[unit.value].finer;

/** The figure alone, and with its unit. `digits` are those of millimetres. A whole number has its thousands apart. */
export function patternFigure(mm: number, digits = 1): string {
  const fine = patternDigits(digits);
  return fine === 0 && Number.isFinite(mm) ? count(shownMm(mm)) : fixed(shownMm(mm), fine);
}
export const patternLength = (mm: number, digits = 1): string => `${patternFigure(mm, digits)} ${patternSign()}`;

/** A small length: with one digit more below a centimetre; a thousandth of an inch is fine enough. */
export const mmSmall = (mm: number): string => patternLength(mm, mm >= 10 || unit.value === 'inch' ? 1 : 2);

// ---- on the body

const kCmPerInch = kMmPerInch / 10;

export const bodySign = (of: LengthUnit): string => (of === 'inch' ? 'in' : 'cm');
export const bodyDigits = (of: LengthUnit): number => (of === 'inch' ? 2 : 1);
export const shownLength = (cm: number, of: LengthUnit): number => (of === 'inch' ? cm / kCmPerInch : cm);
export const centimetres = (shown: number, of: LengthUnit): number => (of === 'inch' ? shown * kCmPerInch : shown);
export const lengthWords = (cm: number, of: LengthUnit): string =>
  `${fixed(shownLength(cm, of), bodyDigits(of))} ${bodySign(of)}`;
