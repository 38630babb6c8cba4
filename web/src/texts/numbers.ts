// Numbers, dates and typed figures in the language that is spoken.

import { language } from './language';

const formats = new Map<string, Intl.NumberFormat>();

function format(digits: number, grouped: boolean): Intl.NumberFormat {
  const key = `${language.value} ${digits} ${grouped}`;
  const known = formats.get(key);
  if (known) return known;
  const made = new Intl.NumberFormat(language.value, {
    minimumFractionDigits: digits,
    maximumFractionDigits: digits,
    useGrouping: grouped,
  });
  formats.set(key, made);
  return made;
}

/** As toFixed: so many digits after the point, or after the comma. */
export const fixed = (value: number, digits: number): string =>
  Number.isFinite(value) ? format(digits, false).format(value) : '–';

/** A whole number, its thousands apart. */
export const count = (value: number): string => format(0, true).format(value);

/** A figure with as many digits as it has, two at most or as many as are told. */
export const plain = (value: number, digits = 2): string =>
  new Intl.NumberFormat(language.value, { maximumFractionDigits: digits, useGrouping: false }).format(value);

/** A day: "3 Feb 2026", "03.02.2026". */
export const day = (ms: number): string =>
  new Date(ms).toLocaleDateString(language.value === 'en' ? 'en-GB' : language.value, { dateStyle: 'medium' });

/** A day with its hour. */
export const moment = (ms: number): string =>
  new Date(ms).toLocaleString(language.value === 'en' ? 'en-GB' : language.value, { dateStyle: 'long', timeStyle: 'short' });

/** "12.5" and "12,5" are the same in every language; anything else is no number. */
export function typed(text: string): number {
  const figure = text.trim().replace(',', '.').replace('−', '-');
  return /^[-+]?(\d+\.?\d*|\.\d+)$/.test(figure) ? Number(figure) : Number.NaN;
}
