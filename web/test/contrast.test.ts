import { describe, expect, it } from 'vitest';
import css from '../src/styles/tokens.css?raw';

/** Tokens of one colour scheme; the dark one stands in the media query and inherits the rest. */
function tokens(dark: boolean): Map<string, string> {
  const [light, night] = css.split('@media');
  const found = new Map<string, string>();
  for (const part of dark ? [light!, night!] : [light!]) {
    for (const [, name, value] of part.matchAll(/--([a-z0-9-]+):\s*(#[0-9a-f]{6})/g)) found.set(name!, value!);
  }
  return found;
}

function luminance(hex: string): number {
  const [r, g, b] = [1, 3, 5]
    .map((i) => parseInt(hex.slice(i, i + 2), 16) / 255)
    .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
}

function contrast(a: string, b: string): number {
  const [dark, bright] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (bright! + 0.05) / (dark! + 0.05);
}

const texts: [string, string[]][] = [
  ['ink', ['ground', 'panel', 'raised', 'hover', 'paper', 'accent-wash', 'bad-wash', 'warn-wash']],
  ['ink-soft', ['ground', 'panel', 'raised', 'hover', 'paper', 'accent-wash']],
  ['ink-faint', ['panel', 'raised']],
  ['accent-ink', ['panel', 'raised', 'hover', 'accent-wash', 'warn-wash']],
  ['on-accent', ['accent', 'accent-hover']],
  ['good', ['panel', 'raised']],
  ['warn', ['panel', 'raised', 'warn-wash', 'hover']],
  ['bad', ['panel', 'raised', 'bad-wash']],
];

describe.each([
  ['light', false],
  ['dark', true],
] as const)('colours of the %s scheme', (_, dark) => {
  const all = tokens(dark);
  it.each(texts)('let one read %s on its grounds', (text, grounds) => {
    for (const ground of grounds) {
      expect(contrast(all.get(text)!, all.get(ground)!), `${text} on ${ground}`).toBeGreaterThanOrEqual(4.5);
    }
  });

  it('let one see the focus and the borders of controls', () => {
    for (const ground of ['ground', 'panel', 'raised']) {
      expect(contrast(all.get('focus')!, all.get(ground)!)).toBeGreaterThanOrEqual(3);
      expect(contrast(all.get('line-strong')!, all.get(ground)!), ground).toBeGreaterThanOrEqual(3);
    }
  });
});
