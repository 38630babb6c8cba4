import { afterEach, describe, expect, it } from 'vitest';
import { accountsOf, entitiesShown, warningsShown } from '../src/state/importDraft';
import { sentences } from '../src/texts/de/sentences';
import { speak, speakCodes } from '../src/texts/language';
import { asRead, toldByForm } from '../src/texts/told';

const readers = import.meta.glob<string>('../../core/pattern/dxf/*.cpp', { query: '?raw', import: 'default', eager: true });

/** What the reader of a DXF looks for in it, errors, which have codes, and places, which the page tells by itself. */
const kNoSentence = /^(on fold|(piece|style) name|base size|without a name|last good |the file has no layer |a layer cannot be read as |the largest piece is |its pieces come in one size)/;

/** Beginnings and parts of sentences; literals that follow each other are one. */
const partsOf = (source: string): string[] =>
  [...source.replace(/\/\/.*/g, '').replace(/"\s*\n\s*"/g, '').matchAll(/"((?:[^"\\\n]|\\.)*)"/g)]
    .map(([, text]) => text!)
    .filter((text) => text.length > 5 && text.includes(' ') && /^[a-z]/.test(text) && !kNoSentence.test(text));

const german = async (): Promise<void> => {
  await speak('de');
  await speakCodes();
};

afterEach(() => speak('en'));

describe('sentences of an import', () => {
  it('have German words, each that the reader of a DXF can say', () => {
    const forms = Object.keys(sentences).map((form) => form.toLowerCase());
    const said = Object.values(readers).flatMap(partsOf);
    const isKnown = (text: string): boolean =>
      forms.some((form) => form.includes(text.toLowerCase().replace(/\.$/, ''))) || /^the POLYLINE is left out: /.test(text);
    expect(said.filter((text) => !isKnown(text))).toEqual([]);
    expect(said.length).toBeGreaterThan(100);
  });

  it('name in German only what varies in English', () => {
    for (const [form, words] of Object.entries(sentences)) {
      const gaps = form.match(/\{#?\}/g)?.length ?? 0;
      const named = [...words.matchAll(/\{(\d)\}/g)].map(([, gap]) => Number(gap));
      expect(new Set(named), form).toEqual(new Set(Array.from({ length: gaps }, (_, i) => i + 1)));
    }
  });

  it.each([
    ['turn point: a curve ends there', 'Eckpunkt: dort endet eine Kurve'],
    ['the cut line (layer 1) gives way to the sew line (layer 14) in line 62', 'Die Schnittlinie (Lage 1) weicht der Nahtlinie (Lage 14) in Zeile 62'],
    ['the outline on layer 01 had a gap of 0.35 mm and was closed', 'Der Umriss auf Lage 01 hatte eine Lücke von 0,35 mm und wurde geschlossen'],
    ['the file has sizes but no sample size: 4.5 is taken', 'Die Datei hat Größen, aber keine Grundgröße: 4.5 wird genommen'],
    ["line 2516: a text says units are 'METRIC' (mm in one system, cm in another)", 'Zeile 2516: Ein Text nennt als Einheit „METRIC“ (mm in einem System, cm in einem anderen)'],
    ['the largest piece measures 660 units: 660 mm as mm, 6600 mm as cm, 16.8 m as inch', 'Das größte Schnittteil misst 660 Einheiten: 660 mm als mm, 6600 mm als cm, 16,8 m als inch'],
    ['the piece is left out: The outline crosses or touches itself at (12.5, 40) mm.', 'Das Schnittteil wird weggelassen: Der Umriss kreuzt oder berührt sich selbst bei (12,5; 40) mm'],
    ['the POLYLINE is left out: the file ends within it', 'POLYLINE wird weggelassen: die Datei endet mitten darin'],
    ['VIEWPORT makes no outline', 'VIEWPORT ergibt keinen Umriss'],
  ])('are told by their form: %s', async (text, words) => {
    expect(toldByForm(text)).toBe(text);
    await german();
    expect(toldByForm(text)).toBe(words);
  });

  it('that nobody knows stay as they are', async () => {
    await german();
    expect([toldByForm('something new was found'), asRead('something new was found')]).toEqual([null, 'something new was found']);
  });

  it('are found by the words that are read', async () => {
    await german();
    const notch = { type: 'POINT', layer: '4', block: '', fate: 'dropped', reason: 'a notch away from the outline', piece: '', count: 1, lines: [] } as const;
    const gap = { line: 1, piece: '', at: null, text: 'the outline on layer 1 had a gap of 2 mm and was closed', count: 1 };
    const filter = { fate: '', piece: '', text: 'abseits' } as const;
    expect(entitiesShown([{ ...notch, lines: [3] }], filter)).toHaveLength(1);
    expect(warningsShown([gap], { ...filter, text: 'lücke' })).toHaveLength(1);
    expect(accountsOf({ counts: { panels: 2, edges: 9, stitches: 1 }, entities: [], warnings: [] }).sum).toBe('2 Schnittteile, 9 Kanten, 1 Naht');
  });
});
