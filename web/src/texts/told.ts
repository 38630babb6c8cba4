// What the service says, for a reader of another language. The service speaks English and gives each message a code.

import { computed } from '@preact/signals';
import { codes, language, sentences } from './language';
import { plain } from './numbers';

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

interface Form {
  words: string;
  pattern: RegExp;
  /** Of each gap, whether a figure stands in it. */
  figures: boolean[];
  /** Letters that do not vary: of two forms that fit, the one that says more is meant. */
  fixed: number;
}

const kGap = /\{#?\}/g;

function formOf([form, words]: readonly [string, string]): Form {
  const figures = [...form.matchAll(kGap)].map(([gap]) => gap === '{#}');
  const parts = form.split(kGap).map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'));
  const gaps = figures.map((figure) => (figure ? '(-?\\d[\\d.e+-]*)' : '(.+?)'));
  const pattern = new RegExp(`^${parts.map((part, i) => part + (gaps[i] ?? '')).join('')}\\.?$`, 'is');
  return { words, pattern, figures, fixed: form.replace(kGap, '').length };
}

const forms = computed(() => Object.entries(sentences.value).map(formOf).sort((one, other) => other.fixed - one.fixed));

/** What stood in a gap may be a sentence of its own. */
function inWords(text: string): string | null {
  for (const { words, pattern, figures } of forms.value) {
    const found = pattern.exec(text);
    if (!found) continue;
    const gaps = figures.map((figure, i) => (figure ? figureOf(found[i + 1]!) : (inWords(found[i + 1]!) ?? found[i + 1]!)));
    return words.replace(/\{(\d)\}/g, (_, gap: string) => gaps[Number(gap) - 1]!);
  }
  return null;
}

const figureOf = (text: string): string => text.replace('.', plain(0.5)[1]!);

/** A sentence of the service that has no code; null where the language that is spoken has no words for it. */
export const toldByForm = (text: string): string | null => (language.value === 'en' ? text : inWords(text));

/** As it is read: in the service's words where there are no others. */
export const asRead = (text: string): string => toldByForm(text) ?? text;
