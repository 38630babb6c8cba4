import { describe, expect, it } from 'vitest';
import { literalsOf } from './texts/literals';

const files = import.meta.glob<string>('../src/**/*.{ts,tsx}', { query: '?raw', import: 'default', eager: true });

/** Shaders are programs; what the api throws is for a log, and told by its code. */
const kWithoutWords = /\/src\/(texts|api|workers)\/|\/scene\/(ClothMaterials|Studio|renderer|seamShader)\.ts$/;

describe('texts that a person reads', () => {
  it('stand in src/texts and nowhere else', () => {
    const sources = Object.entries(files).filter(([file]) => !kWithoutWords.test(file));
    const found = sources.flatMap(([file, source]) => literalsOf(file, source).map((text) => `${file}:${text}`));
    expect(found).toEqual([]);
    expect(sources.length).toBeGreaterThan(100);
  });

  it.each([
    ['between tags', 'const A = () => <p>Nothing is here</p>;'],
    ['in one word between tags', 'const A = () => <b>saved</b>;'],
    ['as what a button is called', 'const A = () => <button aria-label="close" />;'],
    ['as a title that is put together', 'const A = (n: string) => <i title={`remove ${n}`} />;'],
    ['as one of two', "const A = (b: boolean) => <p>{b ? 'Taken' : 'Left'}</p>;"],
    ['in a table', "const kTitles = { front: 'Front view' };"],
    ['as a message', "notify(state, { text: 'The file is gone.' });"],
    ['frozen when the module is loaded', 'const kTitle = t.frame.title;'],
  ])('are found %s', (_, source) => {
    expect(literalsOf('planted.tsx', source)).toHaveLength(source.includes('? ') ? 2 : 1);
  });

  it('are not what a program says to itself', () => {
    const plain = [
      "import { a } from './Some/Where';",
      "const kind: 'Some words' = f('edge');",
      'const A = () => <p class="hint bad">{t.frame.title}</p>;',
      "if (event.key === 'Enter') throw new Error('a component outside of the page');",
    ];
    expect(literalsOf('plain.tsx', plain.join('\n'))).toEqual([]);
  });
});
