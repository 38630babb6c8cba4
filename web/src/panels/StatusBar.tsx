// The drape's figures in one line.

import { useAppState } from '../state/context';
import { activity, isActive, overall } from '../state/jobs';
import { count, millimetres, percent, speed } from '../state/words';

export function StatusBar() {
  const state = useAppState();
  const job = state.job.value;
  const progress = job?.progress ?? null;
  const report = state.report.value?.state === 'ready' ? state.report.value.value : null;
  if (!job)
    return (
      <footer class="status">
        <span class="status-phase">Ready</span>
      </footer>
    );
  const active = isActive(job.state);
  const step = progress?.step ?? report?.steps;
  const simulated = progress?.simulated_s ?? report?.simulated_s;
  const rms = progress?.rms_speed ?? report?.rms_speed;
  const gap = progress?.seam_gap_mm ?? report?.seam_gap_max_mm;
  const crossings = progress
    ? progress.cloth_body + progress.cloth_cloth
    : report
      ? report.intersections.cloth_body + report.intersections.cloth_cloth
      : undefined;
  const perStep = progress?.step_ms || (report ? (1000 * report.wall_s) / Math.max(report.steps, 1) : undefined);
  const fraction = job.state === 'succeeded' ? 1 : progress ? overall(progress.phase, progress.fraction) : 0;
  return (
    <footer class={`status state-${job.state}`} aria-label="Status">
      <span class="status-phase">
        <i class="dot" aria-hidden="true" />
        {activity(job.state, progress?.phase)}
      </span>
      <Figure label="Step" value={step === undefined ? '–' : count(step)} />
      <Figure label="Simulated" value={simulated === undefined ? '–' : `${simulated.toFixed(2)} s`} />
      <Figure label="A step" value={perStep ? `${perStep.toFixed(2)} ms` : '–'} />
      <Figure label="Speed" value={rms === undefined ? '–' : speed(rms)} />
      <Figure label="Seam gap" value={gap === undefined ? '–' : millimetres(gap)} />
      <Figure
        label="Intersections"
        value={crossings === undefined ? '–' : count(crossings)}
        bad={(crossings ?? 0) > 0}
      />
      <span class="status-progress">
        <span
          class={`bar${active && job.state === 'queued' ? ' idle' : ''}`}
          role="progressbar"
          aria-valuemin={0}
          aria-valuemax={100}
          aria-valuenow={Math.round(100 * fraction)}
          aria-label="Progress"
        >
          <i key={job.id} style={{ width: `${100 * fraction}%` }} />
        </span>
        <span class="status-percent">{percent(fraction, 0)}</span>
      </span>
    </footer>
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
