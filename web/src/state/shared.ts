// What the page of a share link knows beside what any view of a drape needs.

import { signal, type Signal } from '@preact/signals';
import type { ApiError } from '../api/http';
import type { SharedJob } from '../api/types';
import type { Loaded } from './AppState';
import { downloadsOf, type Download } from './report';

export class SharedState {
  readonly job: Signal<Loaded<SharedJob>> = signal({ state: 'loading' });
}

/** Why a link opens nothing, as a person is told. */
export interface Closed {
  title: string;
  text: string;
  /** Whether asking again may help. */
  again: boolean;
}

const kClosed: Record<string, Omit<Closed, 'again'>> = {
  'links.expired': { title: 'This link has expired', text: 'It was good for a time that is over. Ask whoever sent it to you for another.' },
  'links.revoked': { title: 'This link was taken back', text: 'Whoever shared the drape has closed it again. Ask them if you still need to see it.' },
  'links.removed': { title: 'This drape is gone', text: 'Its owner has removed it, with its pictures and figures.' },
  'links.unknown': { title: 'This link opens nothing', text: 'Perhaps it was not copied whole: it ends in 64 letters and digits.' },
  'auth.guesses': { title: 'Too many wrong links', text: 'Wait a minute, then try again.' },
};

export function closedBy(error: ApiError): Closed {
  const known = kClosed[error.code];
  if (known) return { ...known, again: error.code === 'auth.guesses' };
  if (error.unreachable) return { title: 'The server does not answer', text: 'Look again in a moment.', again: true };
  return { title: 'This drape cannot be shown', text: error.detail, again: true };
}

/** What may be taken home, of what there is. */
export const takenHome = ({ results }: SharedJob): Download[] => downloadsOf(results);

/** "until 3 March 2027, 14:05", or that it is good for ever. */
export function goodUntil(expires_ms: number, locale = 'en-GB'): string {
  if (expires_ms === 0) return 'This link does not expire.';
  const when = new Date(expires_ms).toLocaleString(locale, { dateStyle: 'long', timeStyle: 'short' });
  return `This link is good until ${when}.`;
}
