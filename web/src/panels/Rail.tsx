// Projects and drapes, with pictures and states.

import type { Job, Project } from '../api/types';
import { useCommands } from '../commands/context';
import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { activity, isActive, newestJobOf, overall, stateNames, thumbnailOf } from '../state/jobs';
import { ago, percent } from '../state/words';
import { Icon } from '../controls/Icon';

export interface PicturesProps {
  /** Address of a result file. */
  resultUrl(job: string, name: string): string;
}

export function Rail({ resultUrl }: PicturesProps) {
  const commands = useCommands();
  return (
    <nav class="rail" aria-label="Projects and drapes">
      <div class="rail-head">
        <h2>Projects</h2>
        <button
          class="tool flat"
          title="New project from files (O)"
          aria-label="New project"
          onClick={() => commands.openIntake()}
        >
          <Icon name="plus" />
        </button>
      </div>
      <ProjectList resultUrl={resultUrl} />
      <div class="rail-head">
        <h2>Drapes</h2>
      </div>
      <JobList resultUrl={resultUrl} />
    </nav>
  );
}

const Skeleton = ({ rows }: { rows: number }) => (
  <ul class="rail-list" aria-label="Loading">
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
  if (projects.state === 'failed') return <p class="hint bad">{projects.error.detail}</p>;
  if (projects.value.length === 0) {
    return (
      <p class="hint">
        No projects yet. Drop a <b>DXF</b> pattern anywhere, or{' '}
        <button class="link" onClick={() => commands.openIntake()}>
          choose files
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
  const finished = state.allJobs.value.filter((job) => job.project_id === project.id && thumbnailOf(job));
  const job = newestJobOf(finished, project.id);
  const drapes = state.allJobs.value.filter((other) => other.project_id === project.id).length;
  return (
    <li>
      <a
        class="row"
        href={`#/projects/${project.id}`}
        aria-current={state.projectId.value === project.id ? 'true' : undefined}
      >
        <Thumb url={job && resultUrl(job.id, thumbnailOf(job)!)} />
        <span class="row-text">
          <b>{project.name}</b>
          <small>
            {drapes === 0 ? 'Not draped yet' : drapes === 1 ? '1 drape' : `${drapes} drapes`} · rev {project.revision}
          </small>
        </span>
      </a>
    </li>
  );
}

function JobList({ resultUrl }: PicturesProps) {
  const state = useAppState();
  const jobs = valueOf(state.jobs.value);
  if (!jobs) return state.jobs.value.state === 'loading' ? <Skeleton rows={3} /> : null;
  if (jobs.length === 0)
    return <p class="hint">What you drape is listed here, with its place in the queue and its picture at the end.</p>;
  return (
    <ul class="rail-list">
      {jobs.map((job) => (
        <JobRow key={job.id} job={job} resultUrl={resultUrl} />
      ))}
    </ul>
  );
}

function JobRow({ job, resultUrl }: { job: Job } & PicturesProps) {
  const state = useAppState();
  const shown = state.job.value?.id === job.id;
  const fresh = shown ? state.job.value : job;
  const name = thumbnailOf(fresh);
  const when = ago(fresh.ended_ms || fresh.created_ms, state.now.value);
  const fraction = fresh.progress ? overall(fresh.progress.phase, fresh.progress.fraction) : 0;
  return (
    <li>
      <a class="row" href={`#/jobs/${job.id}`} aria-current={shown ? 'page' : undefined}>
        <Thumb url={name && resultUrl(job.id, name)} />
        <span class="row-text">
          <b>{job.name}</b>
          <small class={`state-${fresh.state}`}>
            <i class="dot" aria-hidden="true" />
            {fresh.state === 'running' ? activity(fresh.state, fresh.progress?.phase) : stateNames[fresh.state]}
            {isActive(fresh.state) && fresh.state !== 'queued' ? ` · ${percent(fraction, 0)}` : ` · ${when}`}
          </small>
          {isActive(fresh.state) && (
            <span class={`hairbar state-${fresh.state}`}>
              <i style={{ width: percent(fraction, 1).replace(' ', '') }} />
            </span>
          )}
        </span>
      </a>
    </li>
  );
}

function Thumb({ url }: { url: string | null }) {
  return (
    <span class="thumb">{url ? <img src={url} alt="" loading="lazy" decoding="async" /> : <Icon name="shirt" />}</span>
  );
}
