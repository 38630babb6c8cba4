// How long a drape may still take, by the clock. Nobody knows when cloth comes to rest; but speeds fall about evenly on a
// logarithmic scale, and so where that line meets the speed of rest is a fair guess. Pure.

import type { Progress } from '../api/types';
import type { Sample } from './AppState';

/** m/s under which cloth counts as at rest (the document's usual settle_speed_mm_s). */
const kAtRest = 5e-3;
/** s of simulated time in which cloth that seems at rest is looked at closely. */
const kProof = 0.25;
/** s of simulated time over which the trend is taken, and the fewest samples for it. */
const kTrend = 0.8;
const kFewest = 5;

/** Rise of ln(speed) per simulated second: least squares; null where there is too little to tell. */
function trend(samples: readonly Sample[]): number | null {
  const last = samples[samples.length - 1];
  const recent = samples.filter(({ t, speed }) => last !== undefined && t >= last.t - kTrend && speed > 0);
  if (recent.length < kFewest) return null;
  const mean = (of: (sample: Sample) => number): number => recent.reduce((sum, s) => sum + of(s), 0) / recent.length;
  const t = mean((s) => s.t);
  const level = mean((s) => Math.log(s.speed));
  const spread = mean((s) => (s.t - t) ** 2);
  return spread > 0 ? mean((s) => (s.t - t) * (Math.log(s.speed) - level)) / spread : null;
}

/** s by the clock; null while nothing can be said: before it drapes, while it is pulled at, and while it gathers speed. */
export function timeLeft(progress: Progress, samples: readonly Sample[]): number | null {
  const { phase, step, simulated_s, step_ms, fraction, pulls } = progress;
  if (phase !== 'drape' || step <= 0 || simulated_s <= 0 || step_ms <= 0 || pulls > 0) return null;
  const perSimulated = (step / simulated_s) * (step_ms / 1000);
  const last = samples[samples.length - 1];
  const rise = trend(samples);
  if (!last || rise === null || rise >= -0.05) return null;
  const toRest = Math.max(0, Math.log(last.speed / kAtRest) / -rise) + kProof;
  // The drape ends when its time is up, whatever moves: what it has had of it tells how much that is.
  const had = samples[0] ? last.t - samples[0].t : 0;
  const toTheEnd = fraction > 0.02 && had > 0 ? (had * (1 - fraction)) / fraction : Infinity;
  return Math.min(toRest, toTheEnd) * perSimulated;
}
