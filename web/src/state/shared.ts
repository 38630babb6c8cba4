// What the page of a share link knows beside what any view of a drape needs.

import { signal, type Signal } from '@preact/signals';
import type { ApiError } from '../api/http';
import type { SharedJob } from '../api/types';
import type { Loaded } from './AppState';
import { downloadsOf, type Download } from './report';
import type { Texts } from '../texts/en';
import { moment } from '../texts/numbers';
import { told } from '../texts/told';
import { t } from '../texts/language';

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

const kClosed: Record<string, keyof Texts['share']['closed']> = {
  'links.expired': 'expired',
  'links.revoked': 'revoked',
  'links.removed': 'removed',
  'links.unknown': 'unknown',
  'auth.guesses': 'guesses',
};

export function closedBy(error: ApiError): Closed {
  const known = kClosed[error.code];
  if (known) return { ...t.share.closed[known], again: error.code === 'auth.guesses' };
  if (error.unreachable) return { ...t.share.closed.noServer, again: true };
  return { title: t.share.cannotShow, text: told(error.code, error.detail).text, again: true };
}

/** What may be taken home, of what there is. */
export const takenHome = ({ results }: SharedJob): Download[] => downloadsOf(results);

/** "until 3 March 2027, 14:05", or that it is good for ever. */
export function goodUntil(expires_ms: number): string {
  return expires_ms === 0 ? t.share.noEnd : t.share.goodUntil(moment(expires_ms));
}
