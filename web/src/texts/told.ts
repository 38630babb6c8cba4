// What the service says, for a reader of another language. The service speaks English and gives each message a code.

import { codes, language } from './language';

/** A message as a sentence of its own: programs say them in lower case and without a full stop. */
export function sentence(text: string): string {
  const whole = text.charAt(0).toUpperCase() + text.slice(1);
  return whole === '' || /[.!?…]$/.test(whole) ? whole : `${whole}.`;
}

/** The page's own words for a code; empty where it has none. */
const codeText = (code: string): string => codes.value[code] ?? '';

export interface Told {
  text: string;
  /** The service's own words beside it, in English; empty where they are the text. */
  detail: string;
}

/** English is told in the service's own words, which know the figures; elsewhere the page's words for the code come first. */
export function told(code: string, detail: string): Told {
  const known = codeText(code);
  if (language.value === 'en' || known === '') return { text: detail || known, detail: '' };
  return { text: known, detail };
}
