// The page of a share link: its name above, the cloth, and what is told of it; or why there is nothing to see.

import type { ComponentChildren } from 'preact';
import type { SharedApi } from '../api/links';
import type { SharedJob } from '../api/types';
import { useAppState } from '../state/context';
import { activity, isActive } from '../state/jobs';
import { closedBy, type SharedState } from '../state/shared';
import { BrandMark } from '../controls/BrandMark';
import { SharedPanel } from './SharedPanel';
import { StateChip } from './StateChip';
import { t } from '../texts/language';
import { Settings } from './Settings';

interface Props {
  shared: SharedState;
  api: SharedApi;
  again(): void;
  /** The cloth. */
  children: ComponentChildren;
}

export function SharedFrame({ shared, api, again, children }: Props) {
  const loaded = shared.job.value;
  if (loaded.state === 'failed') {
    const why = closedBy(loaded.error);
    return (
      <Bare title={why.title} text={why.text}>
        {why.again && (
          <button class="primary" onClick={again}>
            {t.share.tryAgain}
          </button>
        )}
      </Bare>
    );
  }
  if (loaded.state === 'loading') {
    return (
      <div class="shared-bare" role="status">
        <span class="spinner" aria-hidden="true" />
        <p>{t.share.opening}</p>
      </div>
    );
  }
  return (
    <div class="shared">
      <Head job={loaded.value} />
      <main class="shared-main">
        {children}
        <SharedPanel job={loaded.value} api={api} />
      </main>
    </div>
  );
}

function Head({ job }: { job: SharedJob }) {
  return (
    <header class="topbar shared-top">
      <Mark />
      <h1>{job.name}</h1>
      <StateChip state={job.state} />
      <span class="shared-word" title={t.share.sharedTip}>
        {t.share.shared}
      </span>
      <Settings />
    </header>
  );
}

const Mark = () => (
  <span class="brand">
    <BrandMark />
  </span>
);

function Bare({ title, text, children }: { title: string; text: string; children: ComponentChildren }) {
  return (
    <main class="shared-bare">
      <Mark />
      <h1>{title}</h1>
      <p>{text}</p>
      {children}
    </main>
  );
}

/** Over the stage while there is no cloth. */
export function SharedTold({ shared }: { shared: SharedState }) {
  const state = useAppState();
  const loaded = shared.job.value;
  if (state.covered.value || loaded.state !== 'ready') return null;
  const job = loaded.value;
  if (!isActive(job.state) && !job.cloth) return <p class="scene-message compact">{t.share.noCloth}</p>;
  const doing = isActive(job.state) ? activity(job.state, state.progress.value?.phase) : t.share.fetching;
  return (
    <div class="scene-message quiet" role="status">
      <span class="spinner" aria-hidden="true" />
      <p>{doing}…</p>
    </div>
  );
}
