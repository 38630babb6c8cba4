// Two drapes side by side: what is loaded of each, and their figures in one table.

import { signal, type Signal } from '@preact/signals';
import type { BodyMesh } from '../api/body';
import type { ClothTopology } from '../api/frames';
import type { ApiError } from '../api/http';
import type { Job, Report, SeenPiece } from '../api/types';
import { fitRows } from './fit';
import { stopText } from './report';
import { count, duration, inSentence, percent, seconds } from './words';
import { lengthWords, type LengthUnit } from '../texts/units';
import type { MapKind } from './clothMaps';
import type { Finish } from './fabrics';
import type { Look } from './texture';
import { t } from '../texts/language';

/** How a drape ended, whole. */
export interface ComparedDrape {
  job: Job;
  topology: ClothTopology;
  positions: Float32Array;
  /** Null: it hung without a body, or that cannot be had. */
  body: BodyMesh | null;
  /** As they were draped: their colours and grains. */
  pieces: readonly SeenPiece[];
  /** The pictures that were on them. */
  looks: ReadonlyMap<string, Look>;
  finishes: ReadonlyMap<string, Finish>;
  report: Report | null;
}

export type Compared =
  | { state: 'loading' }
  | { state: 'ready'; value: ComparedDrape }
  | { state: 'failed'; error: ApiError };

export class ComparisonState {
  readonly left: Signal<Compared | null> = signal(null);
  readonly right: Signal<Compared | null> = signal(null);
  readonly mapKind: Signal<MapKind | null> = signal(null);
}

export const comparedOf = (side: Compared | null): ComparedDrape | null =>
  side?.state === 'ready' ? side.value : null;

const hasCloth = (job: Job): boolean => job.results['final.obj'] !== undefined;

/** What a drape can be set beside: those that have cloth to show, of its own project first, the newest first. */
export function comparable(jobs: readonly Job[], to: Job): Job[] {
  if (!hasCloth(to)) return [];
  const others = jobs.filter((job) => job.id !== to.id && hasCloth(job));
  const foreign = (job: Job): number => (job.project_id === to.project_id ? 0 : 1);
  return others.sort((a, b) => foreign(a) - foreign(b) || b.created_ms - a.created_ms);
}

export interface ComparisonRow {
  title: string;
  left: string;
  right: string;
  /** Whether the two say different things. */
  differs: boolean;
}

const kNothing = '–';

type Tell = (report: Report) => string;
const figuresTold = (unit: LengthUnit): [title: string, tell: Tell][] => [
  [t.report.lines.ending, ({ settled, stop_reason }) => (settled ? t.report.compared.settled : stopText(stop_reason))],
  [t.report.lines.worn, ({ worn }) => t.report.wornWords[worn ?? 'yes'] ?? kNothing],
  [t.report.lines.intersections, ({ intersections: { cloth_body, cloth_cloth } }) => count(cloth_body + cloth_cloth)],
  [t.report.compared.warp, ({ strain: { warp } }) => percent((warp.tension ?? warp).p99)],
  [t.report.compared.weft, ({ strain: { weft } }) => percent((weft.tension ?? weft).p99)],
  [t.report.compared.shear, ({ strain: { shear } }) => percent(shear.p99)],
  [t.report.compared.lowest, ({ lowest_m }) => lengthWords(100 * lowest_m, unit)],
  [t.report.compared.highest, ({ highest_m }) => lengthWords(100 * highest_m, unit)],
  [t.report.compared.particles, ({ particles }) => count(particles)],
  [t.report.compared.rest, ({ simulated_s }) => seconds(simulated_s, 2)],
  [t.report.compared.computed, ({ cpu_s }) => duration(cpu_s)],
];

/** How many of them tell how it ended; what is of the fit comes after those. */
const kEnding = 3;

/** All figures of both, and the ease at every girth that one of them has; a figure that one lacks is "–". */
export function comparisonRows(left: Report | null, right: Report | null, unit: LengthUnit): ComparisonRow[] {
  const row = (title: string, a: string, b: string): ComparisonRow => ({ title, left: a, right: b, differs: a !== b });
  const figures = figuresTold(unit).map(([title, tell]) =>
    row(title, left ? tell(left) : kNothing, right ? tell(right) : kNothing),
  );
  const [fitLeft, fitRight] = [left, right].map((report) => (report ? fitRows(report, unit) : []));
  const places = new Map([...fitLeft!, ...fitRight!].map(({ at, title }) => [at, title]));
  const ease = [...places].map(([at, title]) => {
    const of = (rows: typeof fitLeft): string => rows!.find((one) => one.at === at)?.ease ?? kNothing;
    return row(t.report.compared.ease(inSentence(title)), of(fitLeft), of(fitRight));
  });
  return [...figures.slice(0, kEnding), ...ease, ...figures.slice(kEnding)];
}

/** Root mean square of how far vertices lie apart, mm; null where the two are not of the same mesh. */
export function apart(left: ComparedDrape, right: ComparedDrape): number | null {
  const [a, b] = [left.topology, right.topology];
  const same =
    a.vertexCount === b.vertexCount &&
    a.pieces.length === b.pieces.length &&
    a.pieces.every((piece, i) => piece.id === b.pieces[i]!.id && piece.firstVertex === b.pieces[i]!.firstVertex) &&
    a.rest.every((x, i) => Math.abs(x - b.rest[i]!) < 1e-5);
  if (!same) return null;
  const squares = left.positions.reduce((sum, x, i) => sum + (x - right.positions[i]!) ** 2, 0);
  return 1000 * Math.sqrt(squares / a.vertexCount);
}
