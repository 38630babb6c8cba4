// Numbers as people read them. Pure.

const grouped = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });

export const count = (n: number): string => grouped.format(n);

/** "1 piece", "4 pieces". */
export const counted = (n: number, one: string, many = `${one}s`): string => `${count(n)} ${n === 1 ? one : many}`;

export function bytes(n: number): string {
  if (n < 1000) return `${n} B`;
  if (n < 1e6) return `${(n / 1e3).toFixed(n < 1e4 ? 1 : 0)} kB`;
  return `${(n / 1e6).toFixed(1)} MB`;
}

/** A file's name without its ending. */
export const stem = (name: string): string => name.replace(/\.[^.]*$/, '');

/** A message as a sentence of its own: programs say them in lower case and without a full stop. */
export function sentence(text: string): string {
  const whole = text.charAt(0).toUpperCase() + text.slice(1);
  return whole === '' || /[.!?…]$/.test(whole) ? whole : `${whole}.`;
}

/** A length of time in its two largest useful units. */
export function duration(seconds: number): string {
  if (!Number.isFinite(seconds) || seconds < 0) return '–';
  if (seconds < 10) return `${seconds.toFixed(1)} s`;
  if (seconds < 60) return `${Math.round(seconds)} s`;
  const minutes = Math.floor(seconds / 60);
  if (minutes < 60) return `${minutes} min ${Math.round(seconds % 60)} s`;
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** How long ago, for lists. */
export function ago(then: number, now: number): string {
  const seconds = Math.max(0, (now - then) / 1000);
  if (seconds < 45) return 'just now';
  if (seconds < 5400) return `${Math.max(1, Math.round(seconds / 60))} min ago`;
  if (seconds < 86400) return `${Math.round(seconds / 3600)} h ago`;
  return counted(Math.round(seconds / 86400), 'day') + ' ago';
}

/** Metres a second, told in mm/s. */
export function speed(metresPerSecond: number): string {
  const mm = metresPerSecond * 1000;
  return `${mm >= 100 ? count(mm) : mm.toFixed(1)} mm/s`;
}

export const millimetres = (mm: number): string => `${mm >= 10 ? mm.toFixed(1) : mm.toFixed(2)} mm`;

export const percent = (fraction: number, digits = 1): string => `${(100 * fraction).toFixed(digits)} %`;
