// What a language does with numbers: its plural forms, its digits and its separators.

export type Language = 'en' | 'de';


/** A language's numbers: whole ones, and those with a word. */
export function grammar(language: Language) {
  const rules = new Intl.PluralRules(language);
  const whole = new Intl.NumberFormat(language, { maximumFractionDigits: 0 });
  const number = (n: number): string => whole.format(n);
  /** "1 piece", "4 pieces". */
  const counted = (n: number, one: string, other: string): string =>
    `${number(n)} ${rules.select(n) === 'one' ? one : other}`;
  return { number, counted };
}
