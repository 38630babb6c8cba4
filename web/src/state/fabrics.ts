// Fabrics of the library as a person chooses them: what they are, how they fall and give, and which fit some words. Pure.

import type { Fabric, Piece } from '../api/types';
import { fixed, plain } from '../texts/numbers';
import { library, t, type FabricWords } from '../texts/language';
import { isObject, listOf } from './documents';

const kGravity = 9.81;
/** N/m, at which the tensile test of the KES ends: firmly pulled. */
const kPull = 490;

/** Length of a strip that bends under its own weight as the cantilever test has it, mm: c = ∛(B / w g). */
export function bendingLength(bend_un_m: number, areal_mass_g_m2: number): number {
  return 1000 * Math.cbrt((bend_un_m * 1e-6) / (areal_mass_g_m2 * 1e-3 * kGravity));
}

/** How much it is longer when it is firmly pulled, percent; beyond its curve as it ends. */
export function giveOf(curve: Fabric['stretch_warp']): number {
  let [strain, tension] = [0, 0];
  for (const point of curve) {
    if (point.tension_n_m >= kPull) {
      const share = (kPull - tension) / (point.tension_n_m - tension);
      return strain + share * (point.strain_percent - strain);
    }
    [strain, tension] = [point.strain_percent, point.tension_n_m];
  }
  return tension > 0 ? (strain * kPull) / tension : 0;
}

/** mm, from a silk that runs through the fingers to a board. */
const kSoftest = 8;
const kStiffest = 45;

/** From 0, soft, to 1, stiff. */
export function stiffness(fabric: Fabric): number {
  const mean = (fabric.bend_warp_un_m + fabric.bend_weft_un_m) / 2;
  const length = bendingLength(mean, fabric.areal_mass_g_m2);
  return Math.min(1, Math.max(0, (length - kSoftest) / (kStiffest - kSoftest)));
}

const kHands = ['flows', 'soft', 'body', 'firm', 'stands'] as const;

/** The hand in a word. */
export const handOf = (fabric: Fabric): string => t.fabric.hands[kHands[Math.min(4, Math.floor(5 * stiffness(fabric)))]!];

export type Weave = 'plain' | 'twill' | 'satin' | 'knit' | 'net' | 'felt';

/** What its threads look like. */
export function weaveOf({ construction, weave }: Pick<Fabric, 'construction' | 'weave'>): Weave {
  if (construction === 'knit') return 'knit';
  if (construction === 'net') return 'net';
  if (construction !== 'woven') return 'felt';
  if (weave.includes('twill')) return 'twill';
  return weave.includes('satin') ? 'satin' : 'plain';
}

/** How light plays on a fabric. */
export interface Finish {
  weave: Weave;
  /** 0, a mirror, to 1, chalk. */
  roughness: number;
  /** How much of its colour fibres that stand off give back where it is seen at a slant. */
  sheen: number;
  /** m, of the cloth: seams of thick cloth stand up more. */
  thickness: number;
}

export const kPlainFinish: Finish = { weave: 'plain', roughness: 0.92, sheen: 0.16, thickness: 0.0005 };

const kFinishes: [RegExp, Omit<Finish, 'weave' | 'thickness'>][] = [
  [/leather/, { roughness: 0.5, sheen: 0 }],
  [/satin|charmeuse/, { roughness: 0.44, sheen: 0.1 }],
  [/habotai|taffeta|organza|nylon|swim|tricot/, { roughness: 0.58, sheen: 0.08 }],
  [/velvet|pile|fleece|felt|flannel|raised|wool/, { roughness: 1, sheen: 0.45 }],
  [/knit|jersey|rib|interlock|ponte/, { roughness: 0.96, sheen: 0.24 }],
];

export function finishOf(fabric: Pick<Fabric, 'name' | 'title' | 'fibre' | 'weave' | 'construction' | 'thickness_mm'>): Finish {
  const words = `${fabric.name} ${fabric.title} ${fabric.fibre} ${fabric.weave} ${fabric.construction}`.toLowerCase();
  const found = kFinishes.find(([pattern]) => pattern.test(words))?.[1] ?? kPlainFinish;
  return { roughness: found.roughness, sheen: found.sheen, weave: weaveOf(fabric), thickness: fabric.thickness_mm / 1000 };
}

/** Of pieces, by their ids; those of fabrics that nothing is known of are left out. */
export function finishesOf(pieces: readonly Pick<Piece, 'id' | 'fabric'>[], fabrics: readonly Fabric[]): ReadonlyMap<string, Finish> {
  const known = new Map(fabrics.map((fabric) => [fabric.name, finishOf(fabric)]));
  return new Map(pieces.flatMap(({ id, fabric }) => (known.has(fabric) ? [[id, known.get(fabric)!]] : [])));
}

/** What it is called, made of and used for, in the language that is spoken where the page has words for it. */
export const wordsOf = (fabric: Fabric): FabricWords =>
  library.value[fabric.name] ?? { title: fabric.title, make: makeOf(fabric), use: fabric.use ?? '' };

/** "cotton, plain": without what is no word of cloth. */
const makeOf = ({ fibre, weave, construction }: Fabric): string =>
  [fibre === 'many' ? '' : fibre, weave === 'none' || weave === 'many' ? construction : weave].filter(Boolean).join(', ');

export interface Figure {
  label: string;
  value: string;
}

const pair = (warp: number, weft: number, digits: number, unit: string): string =>
  `${fixed(warp, digits)} / ${fixed(weft, digits)} ${unit}`;

/** What a card says of it, warp before weft. */
export function figuresOf(fabric: Fabric): Figure[] {
  const { areal_mass_g_m2: mass, thickness_mm, bend_warp_un_m, bend_weft_un_m } = fabric;
  const { stretch_warp, stretch_weft, drape_least_percent: least, drape_most_percent: most } = fabric;
  const figures = [
    { label: t.fabric.mass, value: `${mass} g/m²` },
    { label: t.fabric.thickness, value: `${plain(thickness_mm)} mm` },
    { label: t.fabric.bendingLength, value: pair(bendingLength(bend_warp_un_m, mass), bendingLength(bend_weft_un_m, mass), 0, 'mm') },
    { label: t.fabric.gives, value: pair(giveOf(stretch_warp), giveOf(stretch_weft), 0, '%') },
  ];
  if (least !== undefined && most !== undefined) figures.push({ label: t.fabric.drapeCoefficient, value: `${least}–${most} %` });
  return figures;
}

/** How many of its figures were measured, in words. */
export function originOf({ sources }: Fabric): string {
  const measured = sources.filter((source) => 'source' in source && source.source !== undefined).length;
  if (measured === 0) return t.fabric.estimated;
  return measured === sources.length ? t.fabric.published : t.fabric.mixed;
}

/** A fabric that a document describes itself. */
export interface OwnFabric {
  id: string;
  /** What people call it; empty: nothing but its id. */
  name: string;
  /** The fabric of the library that it begins with; empty: none. */
  like: string;
  /** It has figures of its own. */
  differs: boolean;
}

const kNoFigures: ReadonlySet<string> = new Set(['id', 'name', 'like', 'colour']);

/** Those of a project's document. */
export function ownFabrics(document: unknown): OwnFabric[] {
  return listOf(isObject(document) ? document.fabrics : null).map((fabric) => ({
    id: String(fabric.id),
    name: typeof fabric.name === 'string' ? fabric.name : '',
    like: typeof fabric.like === 'string' ? fabric.like : '',
    differs: Object.keys(fabric).some((key) => !kNoFigures.has(key)),
  }));
}

/** The library's fabric whose figures one of this name has; null: it has its own. */
export function fabricCard(name: string, fabrics: readonly Fabric[], own: readonly OwnFabric[]): Fabric | null {
  const told = own.find((one) => one.id === name);
  if (told?.differs) return null;
  return fabrics.find((one) => one.name === (told?.like || name)) ?? null;
}

/** What a document's own fabric is called: by its own name, or by the library's fabric that it is like; else by its id. */
export function fabricTitle(name: string, fabrics: readonly Fabric[], own: readonly OwnFabric[] = []): string {
  const told = own.find((one) => one.id === name);
  if (!told) return titleOf(name, fabrics) ?? name;
  if (told.name) return told.name;
  const like = titleOf(told.like, fabrics);
  if (!like) return name;
  const title = told.differs ? t.fabric.changedFrom(like) : like;
  const isShared = own.some((one) => one.id !== name && one.like === told.like);
  return isShared ? `${title} (${name})` : title;
}

function titleOf(name: string, fabrics: readonly Fabric[]): string | null {
  const known = fabrics.find((one) => one.name === name);
  return known ? wordsOf(known).title : null;
}

export type Kind = 'all' | 'woven' | 'knit' | 'other';

/** Those of a kind in which every word is found, lightest first. */
export function fabricsFound(fabrics: readonly Fabric[], text: string, kind: Kind): Fabric[] {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const isOf = ({ construction }: Fabric): boolean =>
    kind === 'all' || (kind === 'other' ? construction !== 'woven' && construction !== 'knit' : construction === kind);
  const says = (fabric: Fabric): string => {
    const { title, make, use } = wordsOf(fabric);
    const { name, construction } = fabric;
    return [name, title, make, use, fabric.title, makeOf(fabric), construction, fabric.use, handOf(fabric)].join(' ').toLowerCase();
  };
  return fabrics
    .filter((fabric) => isOf(fabric) && words.every((word) => says(fabric).includes(word)))
    .sort((a, b) => a.areal_mass_g_m2 - b.areal_mass_g_m2 || wordsOf(a).title.localeCompare(wordsOf(b).title));
}
