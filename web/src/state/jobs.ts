// Facts about jobs that several panels need. Pure.

import type { JobAction } from '../api/Api';
import type { Job, JobState, Progress } from '../api/types';
import { t } from '../texts/language';

/** Stands for the project of a drape that a link shows, which nobody is told. */
export const kLinkedProject = 'shared';

export const isActive = (state: JobState): boolean => state === 'queued' || state === 'running' || state === 'paused';

/** Whether its cloth drapes or waits to: resumed, it stands in the queue with all that hangs and whoever holds it. */
export const hasBegun = ({ state, progress }: Job): boolean =>
  state === 'running' || state === 'paused' || (state === 'queued' && (progress?.step ?? 0) > 0);

export const stateName = (state: JobState): string => t.drape.states[state];

const phaseName = (phase: string): string => (t.drape.phases as Record<string, string>)[phase] ?? phase;

/** How much of a drape's time its phases usually take, in their order. */
const kShares: [string, number][] = [
  ['mesh', 0.04],
  ['place', 0.01],
  ['dress', 0.05],
  ['sew', 0.25],
  ['drape', 0.58],
  ['move', 0],
  ['check', 0.02],
  ['stills', 0.05],
];

/** How much of the whole is done, 0 to 1, from how much of a phase is. */
export function overall(phase: string, fraction: number): number {
  let before = 0;
  for (const [name, share] of kShares) {
    if (name === phase) return before + share * Math.min(1, Math.max(0, fraction));
    before += share;
  }
  return 0;
}

/** Phase in words; outside of a run the state says more. */
export function activity(state: JobState, phase: string | undefined): string {
  if (state === 'running') return phase ? phaseName(phase) : t.drape.starting;
  if (state === 'queued') return phaseName('queued');
  return stateName(state);
}

export const commandsOf = (state: JobState): Record<JobAction, boolean> => ({
  pause: state === 'running' || state === 'queued',
  resume: state === 'paused',
  step: state === 'paused',
  cancel: isActive(state),
});

/** How many drapes stand before this one in the queue; `jobs` in any order. */
export function placeInQueue(jobs: readonly Job[], id: string): number {
  const own = jobs.find((job) => job.id === id);
  if (!own) return 0;
  // Ids are given in order: several jobs may come within a millisecond.
  const earlier = (job: Job) =>
    job.created_ms < own.created_ms || (job.created_ms === own.created_ms && job.id < own.id);
  return jobs.filter((job) => job.state === 'queued' && earlier(job)).length;
}

/** The newest job of a project, or null; drapes of sweeps are of other fabrics and bodies than it has. */
export function newestJobOf(jobs: readonly Job[], projectId: string): Job | null {
  return jobs.reduce<Job | null>((best, job) => {
    if (job.project_id !== projectId || job.sweep) return best;
    return !best || job.created_ms > best.created_ms ? job : best;
  }, null);
}

/** Those to list, and those that left nothing and were followed by another of their project; `shown` stays in sight. */
export function withoutStale(jobs: readonly Job[], shown: string | undefined): [listed: Job[], stale: Job[]] {
  const newest = new Set(jobs.map((job) => newestJobOf(jobs, job.project_id)?.id));
  const isStale = (job: Job): boolean =>
    (job.state === 'failed' || job.state === 'cancelled') && job.id !== shown && !newest.has(job.id);
  return [jobs.filter((job) => !isStale(job)), jobs.filter(isStale)];
}

/** The drape that is seen on the first page: one that is under way, or the newest that came to an end. */
export function jobAtHome(jobs: readonly Job[]): Job | null {
  const newest = (some: readonly Job[]): Job | null =>
    some.reduce<Job | null>((best, job) => (!best || job.created_ms > best.created_ms ? job : best), null);
  return (
    newest(jobs.filter((job) => job.state === 'running' || job.state === 'paused')) ??
    newest(jobs.filter((job) => job.state === 'succeeded'))
  );
}

/** A picture of how the drape ended, or null. The small one where the service made one. */
export function thumbnailOf(job: Job): string | null {
  const names = Object.keys(job.results ?? {});
  return ['thumbnail.png', 'thumb.png', 'three-quarter.png', 'front.png'].find((name) => names.includes(name)) ?? null;
}

/** The job as its row and its latest progress together tell it. Late progress does not revive an ended job, but its last figures stay. */
export function withProgress(job: Job, progress: Progress | null): Job {
  if (!progress) return job;
  if (!isActive(job.state)) return { ...job, progress };
  return { ...job, state: progress.state || job.state, progress };
}
