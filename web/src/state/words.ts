// Numbers as people read them, in their language and units.

import { language, t } from '../texts/language';
import { count, fixed } from '../texts/numbers';
import { mmSmall } from '../texts/units';

export { count } from '../texts/numbers';
export { sentence } from '../texts/told';

export function bytes(n: number): string {
  if (n < 1000) return `${n} B`;
  if (n < 1e6) return `${fixed(n / 1e3, n < 1e4 ? 1 : 0)} kB`;
  if (n < 1e9) return `${fixed(n / 1e6, 1)} MB`;
  return `${fixed(n / 1e9, 1)} GB`;
}

/** A file's name without its ending. */
export const stem = (name: string): string => name.replace(/\.[^.]*$/, '');

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** A title in the middle of a sentence: German keeps its capitals. */
export const inSentence = (title: string): string =>
  language.value === 'en' ? title.charAt(0).toLowerCase() + title.slice(1) : title;

export const seconds = (s: number, digits: number): string => `${fixed(s, digits)} s`;

/** A length of time in its two largest useful units. */
export function duration(s: number): string {
  if (!Number.isFinite(s) || s < 0) return '–';
  if (s < 10) return seconds(s, 1);
  if (s < 60) return seconds(s, 0);
  const minutes = Math.floor(s / 60);
  if (minutes < 60) return `${minutes} min ${Math.round(s % 60)} s`;
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** How long ago, for lists. */
export function ago(then: number, now: number): string {
  const passed = Math.max(0, (now - then) / 1000);
  if (passed < 45) return t.common.ago.now;
  if (passed < 5400) return t.common.ago.minutes(Math.max(1, Math.round(passed / 60)));
  if (passed < 86400) return t.common.ago.hours(Math.round(passed / 3600));
  return t.common.ago.days(Math.round(passed / 86400));
}

/** Metres a second, told in mm/s. */
export function speed(metresPerSecond: number): string {
  const mm = metresPerSecond * 1000;
  return `${mm >= 100 ? count(mm) : fixed(mm, 1)} mm/s`;
}

/** A small length that was measured: of seams that stand open, of vertices apart. */
export const millimetres = mmSmall;

export const percent = (fraction: number, digits = 1): string => `${fixed(100 * fraction, digits)} %`;
