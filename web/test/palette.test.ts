import { describe, expect, it } from 'vitest';
import { kSeamColours } from '../src/state/seamView';
import seams from '../src/styles/seams.css?raw';
import tokens from '../src/styles/tokens.css?raw';

const channels = (hex: string): number[] =>
  [1, 3, 5]
    .map((i) => parseInt(hex.slice(i, i + 2), 16) / 255)
    .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
const luminance = (hex: string): number => {
  const [r, g, b] = channels(hex);
  return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
};
const contrast = (a: string, b: string): number => {
  const [dark, bright] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (bright! + 0.05) / (dark! + 0.05);
};

/** OKLab: distances in it are about as large as differences look. */
function lab(hex: string): number[] {
  const [r, g, b] = channels(hex) as [number, number, number];
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}
const difference = (a: string, b: string): number => Math.hypot(...lab(a).map((value, i) => value - lab(b)[i]!));

const coloursIn = (css: string): string[] =>
  [...css.matchAll(/--seam-\d+:\s*(#[0-9a-f]{6})/g)].map((found) => found[1]!);
const tokenIn = (css: string, name: string): string => new RegExp(`--${name}:\\s*(#[0-9a-f]{6})`).exec(css)![1]!;

describe.each([
  ['light', 0],
  ['dark', 1],
] as const)('the seams of the %s scheme', (_, scheme) => {
  const colours = coloursIn(seams.split('@media')[scheme]!);
  const paper = tokenIn(tokens.split('@media')[scheme]!, 'paper');

  it('have twenty colours that keep apart from each other', () => {
    expect(colours.length).toBe(kSeamColours);
    const nearest = colours.flatMap((a, i) => colours.slice(0, i).map((b) => difference(a, b)));
    expect(Math.min(...nearest)).toBeGreaterThan(0.11);
  });

  it('stand out from the paper', () => {
    for (const colour of colours) expect(contrast(colour, paper), colour).toBeGreaterThanOrEqual(3);
  });

  it('are more unlike where they follow each other', () => {
    colours.slice(1).forEach((colour, i) => expect(difference(colour, colours[i]!), colour).toBeGreaterThan(0.15));
  });
});
