// What the page knows of bodies, places and problems: who is dressed, where the pieces stand, what the look at them found.

import { computed, signal, type ReadonlySignal, type Signal } from '@preact/signals';
import type { BodyMesh } from '../api/body';
import type {
  Arrangement,
  BodyPreset,
  BodyTables,
  Check,
  Finding,
  Mannequin,
  MeasureName,
  MeasureRule,
  ProjectBody,
  Severity,
  Sex,
  Stance,
  Start,
  TakenMeasure,
} from '../api/dressing';
import type { ApiError } from '../api/http';
import { unit, type LengthUnit } from '../texts/units';
import { PerProject } from './PerProject';
import { edgeWords, seamTitle, type Sewn } from './seamNames';
import { t } from '../texts/language';



/** Kinds of marks on the body. */
export interface Marks {
  tape: boolean;
  landmarks: boolean;
  boxes: boolean;
}

export class DressingState extends PerProject {
  readonly tables: Signal<BodyTables | null> = signal(null);
  /** What a mesh's name may end with; null while the service has not told. */
  readonly meshEndings: ReadonlySignal<readonly string[] | null> = computed(
    () => this.tables.value?.formats.map(({ ending }) => ending) ?? null,
  );
  readonly bodies: Signal<ProjectBody[] | null> = this.perProject(null);
  readonly mesh: Signal<BodyMesh | null> = this.perProject(null);
  readonly check: Signal<Check | null> = this.perProject(null);
  readonly start: Signal<Start | null> = this.perProject(null);
  /** Why the start cannot be shown. */
  readonly startProblem: Signal<ApiError | null> = this.perProject(null);
  /** Of the arrangement that was made last on this page: what was decided for each piece. */
  readonly arrangement: Signal<Arrangement | null> = this.perProject(null);
  /** How the file that was taken last stood in itself. */
  readonly stance: Signal<{ file: string; asset: string; stance: Stance | null } | null> = this.perProject(null);

  /** What is being done, in words; empty: nothing. */
  readonly busy: Signal<string> = signal('');
  /** Why the last wish for a body was refused. */
  readonly problem: Signal<ApiError | null> = this.perProject(null);
  /** Why the last wish for a place was refused. */
  readonly placeProblem: Signal<ApiError | null> = this.perProject(null);
  /** The body whose measures are shown, by its place in the list. */
  readonly shown: Signal<number> = this.perProject(0);
  readonly unit: Signal<LengthUnit> = unit;
  readonly marks: Signal<Marks> = signal({ tape: true, landmarks: false, boxes: false });
  /** Whether the mirror image of a piece that is placed by hand goes along, on the other side. */
  readonly partners: Signal<boolean> = signal(true);
  /** The landmark that the next click on the body places; null: none. */
  readonly picking: Signal<string | null> = this.perProject(null);
  /** The measure whose tape is lit. */
  readonly lit: Signal<string | null> = signal(null);
  /** The finding that is shown in space; `turn` rises with every click. */
  readonly finding: Signal<{ finding: Finding; turn: number } | null> = this.perProject(null);
}

// ---- names





/** "shoulder_width" → "Shoulder width". */
export function measureTitle(name: string): string {
  const known = (t.names.measures as Record<string, string>)[name];
  if (known) return known;
  const words = name.replaceAll('_', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

// ---- mannequins

const kSexes: readonly Sex[] = ['female', 'male', 'child'];

/** "eu38" → "EU 38", "m50" → "Men 50", "child116" → "116 cm". */
export function presetTitle(name: string): string {
  const number = name.replace(/^\D+/, '');
  if (name.startsWith('eu')) return `EU ${number}`;
  return name.startsWith('child') ? t.names.childSize(number) : t.names.menSize(number);
}

export function presetGroups(presets: BodyPreset[]): { title: string; presets: BodyPreset[] }[] {
  return kSexes
    .map((sex) => ({ title: t.names.sexes[sex], presets: presets.filter((preset) => preset.sex === sex) }))
    .filter((group) => group.presets.length > 0);
}

const key = (measure: MeasureName): `${MeasureName}_cm` => `${measure}_cm`;

/** A size of a table in place of all measures; pose and fineness stay. */
export function withPreset(mannequin: Mannequin | null, preset: string): Mannequin {
  const { pose, arm_angle, triangles } = mannequin ?? {};
  return plain({ preset, pose, arm_angle, triangles });
}

export const withMeasure = (mannequin: Mannequin, measure: MeasureName, cm: number): Mannequin => ({
  ...mannequin,
  [key(measure)]: Math.round(cm * 10) / 10,
});

/** The measure follows from the preset and from proportions again. */
export function withoutMeasure(mannequin: Mannequin, measure: MeasureName): Mannequin {
  const { [key(measure)]: _, ...rest } = mannequin;
  return rest;
}

export const isOwn = (mannequin: Mannequin, measure: MeasureName): boolean => mannequin[key(measure)] !== undefined;

function plain(mannequin: Mannequin): Mannequin {
  return Object.fromEntries(Object.entries(mannequin).filter(([, value]) => value !== undefined));
}

/** The preset that a slider's way is laid around: the mannequin's own, or the one whose girths are nearest. */
export function nearestPreset(presets: BodyPreset[], mannequin: Mannequin, taken: TakenMeasure[]): BodyPreset | null {
  const own = presets.find((preset) => preset.name === mannequin.preset);
  if (own) return own;
  const off = (preset: BodyPreset): number =>
    taken
      .filter(({ name }) => ['height', 'bust', 'waist', 'hip'].includes(name))
      .reduce((sum, { name, cm }) => sum + Math.abs(cm - (preset.measures_cm[name] ?? cm)), 0);
  const alike = presets.filter((preset) => preset.sex === (mannequin.sex ?? 'female'));
  return alike.reduce<BodyPreset | null>((best, one) => (best && off(best) <= off(one) ? best : one), null);
}

/** A slider's way, whole cm: a fifth below and a third above its preset, within what a document may say. */
export function sliderWay(rule: MeasureRule, base: number, value: number): { least: number; most: number } {
  return {
    least: Math.floor(Math.max(rule.least_cm, Math.min(0.8 * base, value))),
    most: Math.ceil(Math.min(rule.most_cm, Math.max(1.33 * base, value))),
  };
}

/** A name for one more body, after its file: "chair.obj" → "chair", "chair_2". */
export function freeBodyId(file: string, taken: string[]): string {
  const stem = file.replace(/\.[^.]*$/, '') || 'object';
  let id = stem;
  for (let n = 2; taken.includes(id); ++n) id = `${stem}_${n}`;
  return id;
}

/** The body whose landmark this is, the shown one first; null where there is none of that name. */
export function bearerOf(bodies: ProjectBody[], shown: number, landmark: string): ProjectBody | null {
  const bears = (body: ProjectBody): boolean => body.landmarks.some((one) => one.name === landmark);
  const first = bodies[shown];
  return first && bears(first) ? first : (bodies.find(bears) ?? null);
}

// ---- findings

const kSeverities: Severity[] = ['error', 'warning', 'note'];

/** What keeps a drape from beginning first; what is repaired already last. */
export function sortedFindings(findings: Finding[]): Finding[] {
  const rank = (finding: Finding): number =>
    (finding.repaired ? kSeverities.length : 0) + kSeverities.indexOf(finding.severity);
  return findings
    .map((finding, i) => ({ finding, i }))
    .sort((a, b) => rank(a.finding) - rank(b.finding) || a.i - b.i)
    .map(({ finding }) => finding);
}

export function findingCounts(findings: Finding[]): Record<Severity | 'repaired', number> {
  const counts = { error: 0, warning: 0, note: 0, repaired: 0 };
  for (const finding of findings) counts[finding.repaired ? 'repaired' : finding.severity] += 1;
  return counts;
}

/** The first piece that a finding is about, if it is one of these. */
export function pieceOf(finding: Finding, pieces: string[]): string | null {
  const first = finding.about.find((concern) => concern.thing === 'piece');
  return first !== undefined && pieces.includes(first.id) ? first.id : null;
}

/** What a finding is about, as a person calls it: seams by the pieces that they join. Empty where nothing is named. */
export function aboutText({ about }: Finding, sewn: Sewn): string {
  return about.flatMap(({ thing, id }, i) => (thing === 'body' ? [] : [`${t.names.things[thing]} ${nameOf(about, i, sewn) ?? id}`])).join(', ');
}

/** Of seams and edges; an edge is of the piece that is named before it. */
function nameOf(about: Finding['about'], index: number, sewn: Sewn): string | null {
  const { thing, id } = about[index]!;
  if (thing === 'seam') return seamTitle(sewn, id);
  const bearer = about.slice(0, index).reverse().find((one) => one.thing === 'piece');
  return thing === 'edge' ? edgeWords(sewn.pieces.find((piece) => piece.id === bearer?.id), id) : null;
}

// ---- places

export const kParts = ['torso', 'hips', 'left_arm', 'right_arm', 'left_leg', 'right_leg', 'neck', 'head'] as const;

/** "left_arm" → "Left arm". */
export const partTitle = measureTitle;
