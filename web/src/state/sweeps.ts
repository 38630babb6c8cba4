// Sweeps as the page knows them: the list, the one that is shown, and what its cells say.

import { signal, type Signal } from '@preact/signals';
import type { Sweep, SweepCell, SweepFigures, SweepSummary } from '../api/sweeps';
import { percent } from './words';
import { lengthWords, type LengthUnit } from '../texts/units';
import { t } from '../texts/language';
import type { Loaded } from './AppState';
import type { Verdict } from './report';

export class SweepState {
  readonly list: Signal<Loaded<SweepSummary[]>> = signal({ state: 'loading' });
  readonly shown: Signal<Loaded<Sweep> | null> = signal(null);
  /** The dialog in which bodies and fabrics are chosen. */
  readonly choosing: Signal<boolean> = signal(false);
  readonly busy: Signal<boolean> = signal(false);
}

/** Drapes of one sweep at most, as the service has it. */
export const kMostSwept = 200;

/** Cells in rows of bodies. */
export function rowsOf(sweep: Sweep): { body: string; cells: SweepCell[] }[] {
  const columns = sweep.fabrics.length;
  return sweep.bodies.map((body, i) => ({ body, cells: sweep.cells.slice(i * columns, (i + 1) * columns) }));
}

export const doneOf = ({ counts }: SweepSummary): number =>
  counts.succeeded + counts.failed + counts.cancelled + counts.removed;
export const cellsOf = ({ bodies, fabrics }: SweepSummary): number => bodies.length * fabrics.length;

/** At the end and in the worst frame. */
const crossingsOf = (f: SweepFigures): number =>
  Math.max(f.cloth_body + f.cloth_cloth, f.worst_body + f.worst_cloth);

/** What a cell comes to in a word or two, and how grave it is. */
export function verdictOf({ figures, state }: SweepCell): { word: string; verdict: Verdict } {
  if (!figures) return { word: state === 'removed' ? t.sweep.removed : t.drape.states[state], verdict: state === 'failed' ? 'warn' : 'plain' };
  if (figures.worn === 'no') return { word: t.sweep.notWorn, verdict: 'warn' };
  if (!figures.settled) return { word: t.sweep.moves, verdict: 'warn' };
  if (crossingsOf(figures) > 0) return { word: t.sweep.crosses(crossingsOf(figures)), verdict: 'warn' };
  if (figures.worn === 'partly') return { word: t.sweep.partlyWorn, verdict: 'warn' };
  return { word: figures.worn === 'yes' ? t.sweep.worn : t.sweep.atRest, verdict: 'good' };
}

const kGirths = ['bust', 'waist', 'hip'] as const;

export interface EaseLine {
  title: string;
  ease: string;
  tight: boolean;
}

/** Of the girths that the garment goes around. */
export function easesOf(figures: SweepFigures, unit: LengthUnit): EaseLine[] {
  return kGirths.flatMap((girth) => {
    const ease = figures[girth];
    if (!ease) return [];
    const cm = ease.ease_mm / 10;
    return [
      {
        title: t.names.measures[girth],
        ease: (cm < 0 ? '−' : '+') + lengthWords(Math.abs(cm), unit),
        tight: ease.fit === 'too_tight',
      },
    ];
  });
}

/** How much the cloth is stretched, along the direction in which it is more. */
export const stretchOf = ({ warp_p99, weft_p99 }: SweepFigures): string => percent(Math.max(warp_p99, weft_p99));
