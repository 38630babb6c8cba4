// The language that the page speaks, and its texts. English comes with the page, others are fetched when they are wanted.

import { batch, signal, type ReadonlySignal } from '@preact/signals';
import { en, type Texts } from './en';
import type { Codes } from './en/codes';
import type { Language } from './grammar';
import { keep, kept } from './kept';

/** What the choice says, each in its own language. */
export const languageNames: Record<Language, string> = { en: 'English', de: 'Deutsch' };

const isLanguage = (word: string | null): word is Language => word !== null && word in languageNames;

const spoken = signal<Language>('en');
const table = signal<Texts>(en);

export const language: ReadonlySignal<Language> = spoken;

/** The texts of the language that is spoken: who reads them in a view is drawn anew when it changes. */
export const t: Texts = new Proxy(en, { get: (_, section) => table.value[section as keyof Texts] });

/** What a fabric of the library is called, made of and used for; empty: the library does not say. */
export interface FabricWords {
  title: string;
  make: string;
  use: string;
}

interface Fetchers {
  texts(): Promise<Texts>;
  codes(): Promise<Codes>;
  library(): Promise<Library>;
  sentences(): Promise<Sentences>;
}

/** Words for sentences of the service that have no code, by their English form: what varies in it is `{}`, a figure `{#}`. */
export type Sentences = Readonly<Record<string, string>>;

type Library = Readonly<Record<string, FabricWords>>;

const fetchers: Record<Language, Fetchers> = {
  en: { texts: () => Promise.resolve(en), codes: async () => (await import('./en/codes')).codes, library: () => Promise.resolve({}), sentences: () => Promise.resolve({}) },
  de: { texts: async () => (await import('./de')).de, codes: async () => (await import('./de/codes')).codes, library: async () => (await import('./de/library')).library, sentences: async () => (await import('./de/sentences')).sentences },
};

const told = signal<Readonly<Record<string, string>>>({});

/** What codes mean. Nothing has gone wrong yet when the page begins: they come after it. */
export const codes: ReadonlySignal<Readonly<Record<string, string>>> = told;

const cloths = signal<Library>({});

/** Words for the library's fabrics, by their names there, where the service's own are of another language. */
export const library: ReadonlySignal<Library> = cloths;

const forms = signal<Sentences>({});

export const sentences: ReadonlySignal<Sentences> = forms;

/** The last one that was asked for: an earlier one that comes later does not count. */
let wanted: Language = 'en';

/** Speaks a language from now on. Where its texts cannot be had the page stays with the one it has. */
export async function speak(next: Language): Promise<void> {
  wanted = next;
  const [texts, fabrics] = await Promise.all([fetchers[next].texts(), fetchers[next].library()]);
  if (wanted !== next) return;
  batch(() => {
    if (next !== spoken.peek()) [told.value, forms.value] = [{}, {}];
    spoken.value = next;
    table.value = texts;
    cloths.value = fabrics;
  });
  if (typeof document !== 'undefined') document.documentElement.lang = next;
}

/** Fetches what codes and sentences without them mean in the language that is spoken. */
export async function speakCodes(): Promise<void> {
  const of = spoken.value;
  const [codesOf, formsOf] = await Promise.all([fetchers[of].codes(), fetchers[of].sentences()]);
  if (spoken.peek() === of) batch(() => ([told.value, forms.value] = [codesOf, formsOf]));
}

/** What a person chose, which the browser keeps. */
export function chooseLanguage(next: Language): Promise<void> {
  keep('language', next);
  return speak(next);
}

/** What was chosen before, or the first of the browser's languages that the page speaks. */
export function firstLanguage(browser: readonly string[]): Language {
  const before = kept('language');
  if (isLanguage(before)) return before;
  return browser.map((tag) => tag.slice(0, 2).toLowerCase()).find(isLanguage) ?? 'en';
}
