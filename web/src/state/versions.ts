// Versions of the project that is shown, and which of them a drape was made of.

import { signal, type Signal } from '@preact/signals';
import type { ApiError } from '../api/http';
import type { Job } from '../api/types';
import type { Version } from '../api/versions';
import { t } from '../texts/language';
import { PerProject } from './PerProject';

export class VersionState extends PerProject {
  /** Newest first. */
  readonly list: Signal<readonly Version[]> = this.perProject([]);
  /** Revision of the project that the list was told for. */
  readonly told: Signal<number> = this.perProject(0);
  /** Why the last wish was refused. */
  readonly problem: Signal<ApiError | null> = this.perProject(null);
  readonly busy: Signal<boolean> = signal(false);
}

/** The newest of those that have the state that the drape was made of. */
export const versionOf = (versions: readonly Version[], job: string): Version | null =>
  versions.find(({ jobs }) => jobs.includes(job)) ?? null;

/** Whether a project at this revision stands as it did when the drape was made. */
export const standsAs = ({ list, told }: VersionState, revision: number, job: string): boolean =>
  told.value === revision && list.value.some(({ current, jobs }) => current && jobs.includes(job));

/** What a drape was made of, in a word: the version's name, or the revision. */
export const madeOf = (versions: readonly Version[], job: Pick<Job, 'id' | 'project_revision'>): string =>
  versionOf(versions, job.id)?.name ?? t.frame.revision(job.project_revision);
