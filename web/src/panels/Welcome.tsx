// The first page: what this is, where a pattern goes, samples to start from, and what was begun before.

import { samples, type Sample } from '../api/samples';
import type { Project } from '../api/types';
import { useCommands } from '../commands/context';
import { Icon } from '../controls/Icon';
import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { newestJobOf, thumbnailOf } from '../state/jobs';
import { ago } from '../state/words';
import { Dropzone } from './Dropzone';
import type { PicturesProps } from './Rail';
import { t } from '../texts/language';

/** Projects that are offered to be gone on with. */
const kRecent = 6;
/** Of their pictures, pixels. */
const kPictureWidth = 320;

export function Welcome({ resultUrl }: PicturesProps) {
  const { projects } = useAppState();
  const recent = [...(valueOf(projects.value) ?? [])].sort((a, b) => b.updated_ms - a.updated_ms).slice(0, kRecent);
  return (
    <section class="welcome" aria-label={t.intake.start}>
      <h1>{t.intake.seeIt}</h1>
      <p>
        {t.intake.lead}
      </p>
      <Dropzone title={t.intake.dropPattern} />
      <h2>{t.intake.orSample}</h2>
      <ul class="cards">
        {samples.map((sample) => (
          <SampleCard key={sample.id} sample={sample} />
        ))}
      </ul>
      {recent.length > 0 && (
        <>
          <h2>{t.intake.goOn}</h2>
          <ul class="cards">
            {recent.map((project) => (
              <ProjectCard key={project.id} project={project} resultUrl={resultUrl} />
            ))}
          </ul>
        </>
      )}
    </section>
  );
}

/** A click makes a project of it and drapes it. */
function SampleCard({ sample }: { sample: Sample }) {
  const { sampling } = useAppState();
  const commands = useCommands();
  const busy = sampling.value === sample.id;
  return (
    <li>
      <button
        class="card"
        disabled={sampling.value !== ''}
        aria-busy={busy}
        title={t.intake.sampleTip}
        onClick={() => void commands.intake.startSample(sample)}
      >
        <span class="card-picture">
          {busy ? <span class="spinner" aria-hidden="true" /> : <img src={sample.picture} alt="" />}
        </span>
        <b>{sample.title}</b>
      </button>
    </li>
  );
}

function ProjectCard({ project, resultUrl }: { project: Project } & PicturesProps) {
  const { allJobs, now } = useAppState();
  const drapes = allJobs.value.filter((job) => job.project_id === project.id);
  const job = newestJobOf(
    drapes.filter((one) => thumbnailOf(one) !== null),
    project.id,
  );
  const picture = job && thumbnailOf(job);
  return (
    <li>
      <a class="card" href={`#/projects/${project.id}`}>
        <span class="card-picture">
          {picture ? (
            <img src={resultUrl(job.id, picture, kPictureWidth)} alt="" loading="lazy" decoding="async" />
          ) : (
            <Icon name="shirt" />
          )}
        </span>
        <b>{project.name}</b>
        <small>{ago(project.updated_ms, now.value)}</small>
      </a>
    </li>
  );
}
