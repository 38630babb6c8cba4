import { describe, expect, it } from 'vitest';
import type { Fabric } from '../src/api/types';
import { bendingLength, fabricCard, fabricsFound, fabricTitle, figuresOf, finishOf, giveOf, handOf, originOf, ownFabrics, stiffness, weaveOf, wordsOf } from '../src/state/fabrics';
import { library as german } from '../src/texts/de/library';
import { speak } from '../src/texts/language';
import { fabricOf } from './samples';

describe('a fabric’s card', () => {
  it('tells the bending length of the cantilever test', () => {
    // Plain cotton of 150 g/m²: 26.6 mm along the warp come of 27.7 µN·m.
    expect(bendingLength(27.7, 150)).toBeCloseTo(26.6, 1);
  });

  it('tells how far a firm pull takes it, within its curve and beyond its end', () => {
    const { stretch_warp, stretch_weft } = fabricOf('a');
    expect(giveOf(stretch_warp)).toBe(6);
    expect(giveOf(stretch_weft)).toBe(10);
    expect(giveOf([{ strain_percent: 10, tension_n_m: 980 }])).toBeCloseTo(5);
    expect(giveOf([])).toBe(0);
    expect(figuresOf(fabricOf('a')).find(({ label }) => label === 'Gives when pulled')?.value).toBe('6 / 10 %');
  });

  it('has its drape coefficient where that is known', () => {
    const labels = (more = {}): string[] => figuresOf(fabricOf('a', more)).map(({ label }) => label);
    expect(labels()).not.toContain('Drape coefficient');
    expect(labels({ drape_least_percent: 60, drape_most_percent: 76 })).toContain('Drape coefficient');
  });

  it('says how it feels, from silk to canvas', () => {
    const silk = fabricOf('silk', { areal_mass_g_m2: 35, bend_warp_un_m: 0.5, bend_weft_un_m: 0.4 });
    const canvas = fabricOf('canvas', { areal_mass_g_m2: 340, bend_warp_un_m: 280, bend_weft_un_m: 260 });
    expect([silk, canvas].map(handOf)).toEqual(['flows', 'stands']);
    expect(stiffness(silk)).toBeLessThan(stiffness(fabricOf('a')));
  });

  it('shows how its threads lie', () => {
    const woven = (weave: string) => weaveOf({ construction: 'woven', weave });
    expect(['plain', '2/2 twill, raised', 'satin', 'cut pile'].map(woven)).toEqual(['plain', 'twill', 'satin', 'plain']);
    const others = ['knit', 'net', 'leather'] as const;
    expect(others.map((construction) => weaveOf({ construction, weave: '' }))).toEqual(['knit', 'net', 'felt']);
    expect(wordsOf(fabricOf('a', { fibre: 'many', weave: 'many' })).make).toBe('woven');
  });

  it('gleams as satin, is matt as wool with a soft rim, and else as most cloth', () => {
    const [satin, wool, cotton] = ['satin', 'wool-flannel', 'poplin'].map((name) => finishOf(fabricOf(name)));
    expect(satin!.roughness).toBeLessThan(cotton!.roughness);
    expect(wool!.roughness).toBeGreaterThan(cotton!.roughness);
    expect(wool!.sheen).toBeGreaterThan(cotton!.sheen);
    expect(cotton!.weave).toBe('twill');
  });

  it('says how much of it was measured', () => {
    const from = (...sources: object[]): string => originOf(fabricOf('a', { sources: sources as never }));
    expect(from({ of: ['friction'], estimated_from: 'x' })).toMatch(/estimated/);
    expect(from({ of: ['friction'], source: 'y' })).toBe('All figures are published.');
    expect(from({ of: [], source: 'y' }, { of: [], estimated_from: 'x' })).toMatch(/^Some/);
  });

  it('is found by any of its words, lightest first', () => {
    const library = [fabricOf('heavy', { areal_mass_g_m2: 400 }), fabricOf('light', { use: 'shirts' }), fabricOf('felt', { construction: 'nonwoven' })];
    const names = (text: string, kind: 'all' | 'woven' | 'knit' | 'other' = 'all'): string[] =>
      fabricsFound(library, text, kind).map(({ name }) => name);
    expect(names('cotton TWILL', 'woven')).toEqual(['light', 'heavy']);
    expect(names('shirts')).toEqual(['light']);
    expect(names('', 'other')).toEqual(['felt']);
    expect(names('', 'knit')).toEqual([]);
  });

  it('is called in the language that is spoken, and found by its words there and by the service’s', async () => {
    const library = [fabricOf('poplin', { title: 'Cotton poplin' }), fabricOf('own', { title: 'Own cloth' })];
    const names = (text: string): string[] => fabricsFound(library, text, 'all').map(({ name }) => name);
    expect(names('popeline')).toEqual([]);
    await speak('de');
    expect(names('popeline blusen')).toEqual(['poplin']);
    expect(names('cotton poplin')).toEqual(['poplin']);
    expect(['poplin', 'own', 'other'].map((name) => fabricTitle(name, library))).toEqual(['Baumwollpopeline', 'Own cloth', 'other']);
    await speak('en');
    expect(fabricTitle('poplin', library)).toBe('Cotton poplin');
  });
});

describe('the library in German', () => {
  const files = import.meta.glob<Fabric>('../../fabrics/*.json', { import: 'default', eager: true });
  const fabrics = Object.values(files);

  it('has words for each fabric, and for none that is not there', () => {
    expect(fabrics.length).toBeGreaterThan(40);
    expect(Object.keys(german).sort()).toEqual(fabrics.map(({ name }) => name).sort());
  });

  it('leaves out nothing that the service says, and keeps its figures', () => {
    const figures = (text: string): string => text.replace(/(\d)\.(\d)/g, '$1,$2').match(/\d+(,\d+)?/g)?.join() ?? '';
    for (const { name, title, use = '' } of fabrics) {
      expect(figures(german[name]!.title)).toBe(figures(title));
      expect(german[name]!.make).not.toBe('');
      expect(german[name]!.use.split(', ').length).toBe(use.split(', ').length);
    }
  });
});

describe('a document’s own fabrics', () => {
  const library = [fabricOf('single-jersey'), fabricOf('rib')];
  const own = ownFabrics({
    fabrics: [
      { id: 'jersey', like: 'single-jersey', colour: [0, 0, 0] },
      { id: 'rib', like: 'rib' },
      { id: 'trim', like: 'rib', areal_mass_g_m2: 300 },
      { id: 'main', name: 'Grey flannel', areal_mass_g_m2: 300 },
      { id: 'x1', areal_mass_g_m2: 100 },
    ],
  });

  it('are called by their name, or as the library calls what they are like; two alike are told apart by their ids', () => {
    const titles = ['jersey', 'rib', 'trim', 'main', 'x1', 'nobody'].map((name) => fabricTitle(name, library, own));
    expect(titles).toEqual(['Title of single-jersey', 'Title of rib (rib)', 'Title of rib, changed (trim)', 'Grey flannel', 'x1', 'nobody']);
  });

  it('have the library’s card where their figures are its own', () => {
    expect(['jersey', 'rib', 'trim', 'main', 'single-jersey', 'x1'].map((name) => fabricCard(name, library, own)?.name)).toEqual([
      'single-jersey', 'rib', undefined, undefined, 'single-jersey', undefined,
    ]);
  });

  it('are none where a document has none', () => {
    expect([ownFabrics(undefined), ownFabrics({}), ownFabrics({ fabrics: 'x' })]).toEqual([[], [], []]);
  });
});
