// The drape's figures in one line.

import type { Job, Progress, Report } from '../api/types';
import { loading, valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { activity, overall } from '../state/jobs';
import { timeLeft } from '../state/timeLeft';
import { count, duration, millimetres, percent, seconds, speed } from '../state/words';
import { t } from '../texts/language';
import { fixed } from '../texts/numbers';

export function StatusBar() {
  const state = useAppState();
  const job = state.job.value;
  if (!job)
    return (
      <footer class="status">
        <span class="status-phase">{t.frame.ready}</span>
      </footer>
    );
  const report = valueOf(state.report.value ?? loading);
  const left = job.state === 'running' && job.progress ? timeLeft(job.progress, state.history.value) : null;
  const figures = {
    ...(report && ended(report)),
    ...(job.progress && underWay(job.progress)),
    ...(left !== null && { left }),
  };
  return (
    <footer class={`status state-${job.state}`} aria-label={t.frame.status}>
      <span class="status-phase">
        <i class="dot" aria-hidden="true" />
        {activity(job.state, job.progress?.phase)}
      </span>
      <Figures figures={figures} />
      <Bar job={job} />
    </footer>
  );
}

/** What is known of a drape; nothing of one that waits. */
interface StatusFigures {
  step?: number;
  /** Simulated time, s. */
  simulated?: number;
  /** Computing time of a step, ms. */
  perStep?: number;
  /** rms, m/s. */
  speed?: number;
  gapMm?: number;
  crossings?: number;
  /** s by the clock, guessed. */
  left?: number;
}

const underWay = (progress: Progress): StatusFigures => ({
  step: progress.step,
  simulated: progress.simulated_s,
  ...(progress.step_ms > 0 && { perStep: progress.step_ms }), // not measured yet in the first message
  speed: progress.rms_speed,
  gapMm: progress.seam_gap_mm,
  crossings: progress.cloth_body + progress.cloth_cloth,
});

const ended = (report: Report): StatusFigures => ({
  step: report.steps,
  simulated: report.simulated_s,
  perStep: (1000 * report.wall_s) / Math.max(report.steps, 1),
  speed: report.rms_speed,
  gapMm: report.seam_gap_max_mm,
  crossings: report.intersections.cloth_body + report.intersections.cloth_cloth,
});

/** A figure in words; a dash for one that is not known. */
const said = (value: number | undefined, words: (value: number) => string): string =>
  value === undefined ? '–' : words(value);

function Figures({ figures }: { figures: StatusFigures }) {
  const { step, simulated, perStep, gapMm, crossings } = figures;
  return (
    <>
      <Figure label={t.frame.figures.step} value={said(step, count)} />
      <Figure label={t.frame.figures.simulated} value={said(simulated, (s) => seconds(s, 2))} />
      <Figure label={t.frame.figures.aStep} value={said(perStep || undefined, (ms) => `${fixed(ms, 2)} ms`)} />
      <Figure label={t.frame.figures.speed} value={said(figures.speed, speed)} />
      <Figure label={t.frame.figures.gap} value={said(gapMm, millimetres)} />
      <Figure label={t.frame.figures.crossings} value={said(crossings, count)} bad={(crossings ?? 0) > 0} />
      {figures.left !== undefined && (
        <Figure label={t.frame.figures.left} value={t.frame.about(duration(Math.max(1, Math.round(figures.left))))} />
      )}
    </>
  );
}

/** How much of the drape is done. */
function doneOf({ state, progress }: Job): number {
  if (state === 'succeeded') return 1;
  return progress ? overall(progress.phase, progress.fraction) : 0;
}

function Bar({ job }: { job: Job }) {
  const fraction = doneOf(job);
  return (
    <span class="status-progress">
      <span
        class={`bar${job.state === 'queued' ? ' idle' : ''}`}
        role="progressbar"
        aria-valuemin={0}
        aria-valuemax={100}
        aria-valuenow={Math.round(100 * fraction)}
        aria-label={t.frame.progress}
      >
        <i key={job.id} style={{ width: `${100 * fraction}%` }} />
      </span>
      <span class="status-percent">{percent(fraction, 0)}</span>
    </span>
  );
}

function Figure({ label, value, bad = false }: { label: string; value: string; bad?: boolean }) {
  return (
    <span class={`figure${bad ? ' bad' : ''}`}>
      <small>{label}</small>
      <b>{value}</b>
    </span>
  );
}
