// Projects and drapes, with pictures and states.

import { useSignal } from '@preact/signals';
import type { Job, Project } from '../api/types';
import { useCommands } from '../commands/context';
import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { activity, isActive, newestJobOf, overall, stateName, thumbnailOf, withoutStale } from '../state/jobs';
import { ago, percent, sentence } from '../state/words';
import { madeOf } from '../state/versions';
import { Icon } from '../controls/Icon';
import { SweepList } from './SweepList';
import { t } from '../texts/language';
import { Told } from '../texts/Message';
import { told } from '../texts/told';

export interface PicturesProps {
  /** Address of a result file; of a still `width` pixels wide. */
  resultUrl(job: string, name: string, width?: number): string;
}

export function Rail({ resultUrl }: PicturesProps) {
  const commands = useCommands();
  return (
    <nav class="rail" aria-label={t.frame.lists}>
      <div class="rail-head">
        <h2>{t.frame.projects}</h2>
        <button
          class="tool flat"
          title={t.frame.newFromFilesKey}
          aria-label={t.common.newProject}
          onClick={() => commands.intake.open()}
        >
          <Icon name="plus" />
        </button>
      </div>
      <ProjectList resultUrl={resultUrl} />
      <SweepList />
      <div class="rail-head">
        <h2>{t.frame.drapes}</h2>
      </div>
      <JobList resultUrl={resultUrl} />
    </nav>
  );
}

/** Pixels: twice as wide as it is shown, for fine screens. */
const kThumbWidth = 96;

const Skeleton = ({ rows }: { rows: number }) => (
  <ul class="rail-list" aria-label={t.frame.loading}>
    {Array.from({ length: rows }, (_, i) => (
      <li key={i} class="row skeleton">
        <span class="thumb" />
        <span class="row-text">
          <b />
          <small />
        </span>
      </li>
    ))}
  </ul>
);

function ProjectList({ resultUrl }: PicturesProps) {
  const state = useAppState();
  const commands = useCommands();
  const projects = state.projects.value;
  if (projects.state === 'loading') return <Skeleton rows={2} />;
  if (projects.state === 'failed') return <p class="hint bad"><Told code={projects.error.code} detail={projects.error.detail} /></p>;
  if (projects.value.length === 0) {
    return (
      <p class="hint">
        {t.frame.noProjects} <b>DXF</b> {t.frame.noProjectsOr}{' '}
        <button class="link" onClick={() => commands.intake.open()}>
          {t.frame.chooseFiles}
        </button>
        .
      </p>
    );
  }
  return (
    <ul class="rail-list">
      {projects.value.map((project) => (
        <ProjectRow key={project.id} project={project} resultUrl={resultUrl} />
      ))}
    </ul>
  );
}

function ProjectRow({ project, resultUrl }: { project: Project } & PicturesProps) {
  const state = useAppState();
  const commands = useCommands();
  const finished = state.allJobs.value.filter((job) => job.project_id === project.id && thumbnailOf(job));
  const job = newestJobOf(finished, project.id);
  const drapes = state.allJobs.value.filter((other) => other.project_id === project.id && !other.sweep).length;
  return (
    <li>
      <a
        class="row"
        href={`#/projects/${project.id}`}
        aria-current={state.projectId.value === project.id ? 'true' : undefined}
      >
        <Thumb url={job && resultUrl(job.id, thumbnailOf(job)!, kThumbWidth)} />
        <span class="row-text">
          <b>{project.name}</b>
          <small>
            {drapes === 0 ? t.common.notDraped : t.frame.drapeCount(drapes)} · {t.frame.revision(project.revision)}
          </small>
        </span>
      </a>
      <Remove what={t.frame.theProject(project.name)} remove={() => commands.removeProject(project.id)} />
    </li>
  );
}

/** Asks once more before it removes anything. */
export function Remove({ what, remove }: { what: string; remove(): Promise<void> }) {
  const asked = useSignal(false);
  return (
    <button
      class={`row-remove${asked.value ? ' asked' : ''}`}
      aria-label={asked.value ? t.frame.reallyRemove(what) : t.frame.remove(what)}
      title={asked.value ? t.frame.removesForGood(what) : t.frame.remove(what)}
      onClick={() => (asked.value ? void remove() : (asked.value = true))}
      onBlur={() => (asked.value = false)}
      onPointerLeave={() => (asked.value = false)}
    >
      {asked.value ? t.frame.removeAsk : <Icon name="cross" />}
    </button>
  );
}

function JobList({ resultUrl }: PicturesProps) {
  const state = useAppState();
  const jobs = valueOf(state.jobs.value);
  if (!jobs) return state.jobs.value.state === 'loading' ? <Skeleton rows={3} /> : null;
  if (jobs.length === 0)
    return <p class="hint">{t.frame.noDrapes}</p>;
  const [shown, stale] = withoutStale(jobs, state.job.value?.id);
  const rows = (some: readonly Job[]) => (
    <ul class="rail-list">
      {some.map((job) => (
        <JobRow key={job.id} job={job} resultUrl={resultUrl} />
      ))}
    </ul>
  );
  return (
    <>
      {rows(shown)}
      {stale.length > 0 && (
        <details class="rail-more">
          <summary>{t.frame.earlier(stale.length)}</summary>
          {rows(stale)}
        </details>
      )}
    </>
  );
}

function JobRow({ job, resultUrl }: { job: Job } & PicturesProps) {
  const state = useAppState();
  const shown = state.job.value?.id === job.id;
  const fresh = shown ? state.job.value : job;
  const name = thumbnailOf(fresh);
  const commands = useCommands();
  const active = isActive(fresh.state);
  return (
    <li>
      <a
        class="row"
        href={`#/jobs/${job.id}`}
        aria-current={shown ? 'page' : undefined}
        title={fresh.reason ? sentence(told(fresh.reason_code, fresh.reason).text) : undefined}
      >
        <Thumb url={name && resultUrl(job.id, name, kThumbWidth)} failed={fresh.state === 'failed'} />
        <span class="row-text">
          <b>{job.name}</b>
          <Standing job={fresh} />
        </span>
      </a>
      {!active && <Remove what={t.frame.theDrape(job.name)} remove={() => commands.removeJob(job.id)} />}
    </li>
  );
}

/** The drape's state in a line, with how far it is or when it was. */
function Standing({ job }: { job: Job }) {
  const { now, versions } = useAppState();
  const { state, progress } = job;
  const active = isActive(state);
  const fraction = progress ? overall(progress.phase, progress.fraction) : 0;
  const when = ago(job.ended_ms || job.created_ms, now.value);
  const word = state === 'running' ? activity(state, progress?.phase) : stateName(state);
  const rest = active && state !== 'queued' ? percent(fraction, 0) : `${madeOf(versions.list.value, job)} · ${when}`;
  return (
    <>
      <small class={`state-${state}`}>
        <i class="dot" aria-hidden="true" />
        <span class={active ? 'gives-way' : ''}>{word}</span>
        <span class={active ? '' : 'gives-way'}>{` · ${rest}`}</span>
      </small>
      {active && (
        <span class={`hairbar state-${state}`}>
          <i style={{ width: `${100 * fraction}%` }} />
        </span>
      )}
    </>
  );
}

function Thumb({ url, failed = false }: { url: string | null; failed?: boolean }) {
  return (
    <span class={`thumb${failed ? ' failed' : ''}`}>
      {url ? <img src={url} alt="" loading="lazy" decoding="async" /> : <Icon name={failed ? 'alert' : 'shirt'} />}
    </span>
  );
}
