import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { ago, bytes, duration, percent } from '../src/state/words';
import { presetTitle } from '../src/state/dressing';
import { lengthsText } from '../src/state/seamView';
import { de } from '../src/texts/de';
import { codes as english } from '../src/texts/en/codes';
import { codes as german } from '../src/texts/de/codes';
import { en } from '../src/texts/en';
import { firstLanguage, language, speak, speakCodes, t } from '../src/texts/language';
import { count, day, fixed, typed } from '../src/texts/numbers';
import { told } from '../src/texts/told';
import { centimetres, chooseUnit, lengthWords, lengthUnits, mmOf, patternDigits, patternLength, shownLength, shownMm, unit } from '../src/texts/units';

const sources = import.meta.glob<string>('../src/**/*.{ts,tsx}', { query: '?raw', import: 'default', eager: true });
/** Where codes are given: the engine, the service, and the page itself. */
const programs = import.meta.glob<string>(
  ['../../core/**/*.{cpp,h}', '../../server/**/*.{cpp,h}', '../src/{api,commands,state}/*.ts'],
  { query: '?raw', import: 'default', eager: true },
);

const kept = new Map<string, string>();
beforeEach(() => {
  kept.clear();
  Object.assign(globalThis, {
    localStorage: { getItem: (key: string) => kept.get(key) ?? null, setItem: (key: string, value: string) => kept.set(key, value) },
  });
});
afterEach(async () => {
  await speak('en');
  unit.value = 'mm';
  Reflect.deleteProperty(globalThis, 'localStorage');
});

type Leaf = string | ((...given: never[]) => string);

/** "frame.settings.title" → its text. */
function leaves(table: object, path = ''): [path: string, leaf: Leaf][] {
  return Object.entries(table).flatMap(([key, value]: [string, unknown]) =>
    typeof value === 'object' && value !== null ? leaves(value, `${path}${key}.`) : [[`${path}${key}`, value as Leaf]],
  );
}

describe('the texts', () => {
  it('are the same in both languages, entry for entry', () => {
    const [one, other] = [leaves({ ...en, english }), leaves({ ...de, english: german })];
    expect(other.map(([path]) => path).sort()).toEqual(one.map(([path]) => path).sort());
    expect(one.length).toBeGreaterThan(900);
    const others = new Map(other);
    expect(one.filter(([path, text]) => typeof text !== typeof others.get(path))).toEqual([]);
    expect([...one, ...other].filter(([, text]) => text === '')).toEqual([]);
  });

  it('are said in German where they are words', () => {
    const others = new Map(leaves({ ...de, codes: german }));
    const same = leaves({ ...en, codes: english }).filter(([path, text]) => typeof text === 'string' && text === others.get(path) && / /.test(text));
    expect(same).toEqual([]);
    // Neither is one half of a translation: English words do not stay behind.
    const left = [...others].filter(([, text]) => typeof text === 'string' && /\b(the|and|of|with|is|are|not)\b/.test(text));
    expect(left).toEqual([]);
  });

  it('have no entry that nobody says', () => {
    const code = Object.entries(sources)
      .filter(([file]) => !/\/texts\/(en|de)/.test(file))
      .map(([, text]) => text)
      .join('\n');
    const said = (section: string, key: string): boolean => {
      const of = new RegExp(`\\bt\\.${section}(\\.${key}\\b|\\[)`);
      const taken = new RegExp(`\\{[^}]*\\b${key}\\b[^}]*\\} = t\\.${section}\\b`);
      return of.test(code) || taken.test(code);
    };
    const unsaid = Object.entries(en)
      .flatMap(([section, entries]) => Object.keys(entries).filter((key) => !said(section, key)).map((key) => `${section}.${key}`));
    expect(unsaid).toEqual([]);
  });
});

/** Families of the command line, which no page shows. */
const kElsewhere = /^(usage|client|log|trace|calibrate|preflight)\./;
const kFile = /\.(bin|bmp|cpp|css|dae|db|dxf|film|frag|gif|glb|gltf|h|html|hung|jpe?g|js|json|jsonl|lock|log|map|md|mp4|avi|obj|ico|pdf|pem|ply|png|sqlite|stl|svg|tmp|toile|trace|ts|tsx|txt|vert|wasm|webp|zip|off|mtl|fbx|glsl|3ds|x|csv)$/;

/** How a job ends where nothing is at fault: codes without a family. */
const kEndings = ['settled', 'time', 'open_seam', 'cancelled'];

/** Of what begins like a family of codes, all that follow a quote and are whole. */
function codesGiven(): Set<string> {
  const families = new Set(Object.keys(english).map((code) => code.split('.')[0]!));
  const given = Object.values(programs).flatMap((text) => [...text.matchAll(/["']([a-z]+\.[a-z0-9_]*[a-z0-9])["']/g)].map(([, code]) => code!));
  const ends = kEndings.filter((code) => Object.values(programs).some((text) => text.includes(`"${code}"`)));
  return new Set([...ends, ...given].filter((code) => kEndings.includes(code) || (families.has(code.split('.')[0]!) && !kFile.test(code) && !kElsewhere.test(code))));
}

describe('codes', () => {
  it('have words in both languages, each that the service or the page can give', () => {
    const given = codesGiven();
    expect([...given].filter((code) => !(code in english)).sort()).toEqual([]);
    expect(given.size).toBeGreaterThan(300);
    // How a measure is taken is told by its name.
    expect(Object.keys(english).filter((code) => !given.has(code) && !code.startsWith('measure.'))).toEqual([]);
  });

  it('are told in the service’s own words in English, and by the page in another language', async () => {
    expect(told('dxf.open_outline', 'line 12 is open')).toEqual({ text: 'line 12 is open', detail: '' });
    await speakCodes();
    expect(told('dxf.open_outline', '').text).toBe('The outline of a piece is not closed');
    await speak('de');
    expect(told('dxf.open_outline', 'line 12 is open').text).toBe('line 12 is open');
    await speakCodes();
    expect(told('dxf.open_outline', 'line 12 is open')).toEqual({
      text: 'Der Umriss eines Schnittteils ist nicht geschlossen',
      detail: 'line 12 is open',
    });
    expect(told('new.code', 'something new')).toEqual({ text: 'something new', detail: '' });
  });
});

describe('a language', () => {
  it('is what was chosen before, or the first of the browser’s that the page speaks', () => {
    expect(firstLanguage(['fr-FR', 'de-AT', 'en'])).toBe('de');
    expect([firstLanguage(['en-US', 'de']), firstLanguage(['fr']), firstLanguage([])]).toEqual(['en', 'en', 'en']);
    kept.set('toile.language', 'de');
    expect(firstLanguage(['en-US'])).toBe('de');
    kept.set('toile.language', 'xx');
    expect(firstLanguage(['en-US'])).toBe('en');
  });

  it('is spoken without a reload, by texts, plurals, numbers and dates', async () => {
    expect([language.value, t.frame.drapeCount(1), t.frame.drapeCount(1500)]).toEqual(['en', '1 drape', '1,500 drapes']);
    await speak('de');
    expect([language.value, t.frame.projects, t.frame.drapeCount(1), t.frame.drapeCount(1500)]).toEqual([
      'de',
      'Projekte',
      '1 Drapierung',
      '1.500 Drapierungen',
    ]);
    expect([count(12345), fixed(1.25, 1), percent(0.123), bytes(2.5e6), duration(3.21)]).toEqual(['12.345', '1,3', '12,3 %', '2,5 MB', '3,2 s']);
    expect([ago(0, 86400e3), ago(0, 3 * 86400e3), presetTitle('m50'), day(0)]).toEqual(['vor 1 Tag', 'vor 3 Tagen', 'Herren 50', '01.01.1970']);
    await speak('en');
    expect([t.frame.projects, count(12345), fixed(1.25, 1), ago(0, 86400e3)]).toEqual(['Projects', '12,345', '1.3', '1 day ago']);
  });

  it('that was asked for last counts, whichever comes first', async () => {
    const german = speak('de');
    const english = speak('en');
    await Promise.all([german, english]);
    expect(language.value).toBe('en');
  });
});

describe('figures that are typed', () => {
  it('may have a point or a comma, and are no number otherwise', () => {
    expect([typed('12.5'), typed('12,5'), typed(' −3 '), typed('.5')]).toEqual([12.5, 12.5, -3, 0.5]);
    expect(['', 'a', '1.234,5', '1,2,3', '12 mm'].map((text) => Number.isNaN(typed(text)))).toEqual([true, true, true, true, true]);
  });
});

describe('units', () => {
  it('hold for the pattern and the body, and go there and back', () => {
    for (const one of lengthUnits) {
      chooseUnit(one);
      expect(mmOf(shownMm(412.7))).toBeCloseTo(412.7, 9);
      expect(centimetres(shownLength(71.3, one), one)).toBeCloseTo(71.3, 9);
    }
    expect(kept.get('toile.lengths')).toBe('inch');
  });

  it('are told with as many digits as they need', async () => {
    const said = (): string[] => [patternLength(254), lengthWords(76.2, unit.value), lengthsText(254, 279.4).difference];
    expect(said()).toEqual(['254.0 mm', '76.2 cm', '25.4 mm (10.0 %)']);
    expect(patternLength(7803.4, 0)).toBe('7,803 mm');
    chooseUnit('cm');
    expect(said()).toEqual(['25.40 cm', '76.2 cm', '2.54 cm (10.0 %)']);
    chooseUnit('inch');
    expect([said(), patternDigits(1)]).toEqual([['10.000 in', '30.00 in', '1.000 in (10.0 %)'], 3]);
    await speak('de');
    expect(said()).toEqual(['10,000 in', '30,00 in', '1,000 in (10,0 %)']);
  });
});
