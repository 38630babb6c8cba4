// Named states of the project: one line each, with its drapes and the way back to it; and a field that names this one.

import { useSignal } from '@preact/signals';
import type { Version } from '../api/versions';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { stateName } from '../state/jobs';
import { ago } from '../state/words';
import { t } from '../texts/language';
import { Told } from '../texts/Message';
import { Remove } from './Rail';

export function VersionList() {
  const { versions } = useAppState();
  return (
    <section class="versions" aria-label={t.versions.title}>
      <h3>{t.versions.title}</h3>
      <NameField />
      {versions.list.value.length > 0 && (
        <ul>
          {versions.list.value.map((version) => (
            <Line key={version.id} version={version} />
          ))}
        </ul>
      )}
    </section>
  );
}

function NameField() {
  const { versions } = useAppState();
  const commands = useCommands();
  const text = useSignal('');
  const problem = versions.problem.value;
  const keep = async (event: Event): Promise<void> => {
    event.preventDefault();
    if (text.value.trim() !== '' && (await commands.versions.name(text.value))) text.value = '';
  };
  return (
    <form class="version-name" onSubmit={(event) => void keep(event)}>
      <input
        type="text"
        aria-label={t.versions.nameOf}
        placeholder={t.versions.nameOf}
        maxLength={60}
        value={text.value}
        onInput={(event) => (text.value = event.currentTarget.value)}
      />
      <button class="plain" disabled={versions.busy.value || text.value.trim() === ''}>
        {t.versions.keep}
      </button>
      {problem && (
        <p class="hint bad" role="alert">
          <Told code={problem.code} detail={problem.detail} /> <span class="code">{problem.code}</span>
        </p>
      )}
    </form>
  );
}

function Line({ version }: { version: Version }) {
  const state = useAppState();
  const commands = useCommands();
  return (
    <li class={version.current ? 'current' : ''}>
      <span>
        <b>{version.name}</b>
        <small>{version.current ? t.versions.current : ago(version.created_ms, state.now.value)}</small>
      </span>
      {!version.current && (
        <button
          class="plain"
          disabled={state.editing.busy.value}
          title={t.versions.restoreTip}
          aria-label={t.versions.restoreIt(version.name)}
          onClick={() => void commands.versions.restore(version.id)}
        >
          {t.versions.restore}
        </button>
      )}
      <Remove what={t.versions.the(version.name)} remove={() => commands.versions.remove(version.id)} />
      <Drapes ids={version.jobs} />
    </li>
  );
}

/** Those that the list of drapes has as well. */
function Drapes({ ids }: { ids: readonly string[] }) {
  const { allJobs, now } = useAppState();
  const drapes = allJobs.value.filter((job) => ids.includes(job.id));
  if (drapes.length === 0) return null;
  return (
    <small class="version-drapes">
      {drapes.map((job) => (
        <a key={job.id} href={`#/jobs/${job.id}`} class={`state-${job.state}`}>
          <i class="dot" aria-hidden="true" />
          {`${stateName(job.state)} · ${ago(job.ended_ms || job.created_ms, now.value)}`}
        </a>
      ))}
    </small>
  );
}
