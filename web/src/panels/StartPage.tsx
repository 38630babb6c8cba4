// What stands where the work will be when there is none to show: the first page, an address that leads nowhere, no service.

import type { AppState } from '../state/AppState';
import { useAppState } from '../state/context';
import type { Route } from '../state/routes';
import type { PicturesProps } from './Rail';
import { Welcome } from './Welcome';
import { t } from '../texts/language';

/** What is said of an address by what it names. */
const lost = (name: Route['name']): string => ({ home: '',
  job: t.frame.lostPages.job,
  project: t.frame.lostPages.project,
  compare: t.frame.lostPages.compare,
  sweep: '', // says so itself
  admin: '', // likewise
  shared: '', // has a page of its own
  unknown: t.frame.lostPages.unknown,
  })[name];

/** Whether the address names what is not there. */
function leadsNowhere({ route, job, project, allJobs }: AppState): boolean {
  const now = route.value;
  if (now.name === 'compare') return [now.left, now.right].some((id) => !allJobs.value.some((one) => one.id === id));
  return now.name === 'unknown' || (now.name === 'job' && !job.value) || (now.name === 'project' && !project.value);
}

/** Null where there is work to show. */
export function StartPage({ resultUrl }: PicturesProps) {
  const state = useAppState();
  const { projects, jobs } = state;
  if (projects.value.state === 'failed' && jobs.value.state === 'failed') {
    return (
      <Sheet title={t.frame.noServer} code={projects.value.error.code}>
        <p>
          {t.frame.noServerWhy}
        </p>
        <p>
          {t.frame.startsBefore} <code>./run</code> {t.frame.startsAfter}
        </p>
      </Sheet>
    );
  }
  if (state.atHome.value) return <Welcome resultUrl={resultUrl} />;
  if (projects.value.state !== 'ready' || jobs.value.state !== 'ready') return null;
  if (leadsNowhere(state)) {
    return (
      <Sheet title={t.frame.nothing} code={location.hash}>
        <p>{lost(state.route.value.name)}</p>
        <p>
          <a class="button primary" href="#/">
            {t.frame.toStartPage}
          </a>
        </p>
      </Sheet>
    );
  }
  return null;
}

function Sheet({ title, code = '', children }: { title: string; code?: string; children: preact.ComponentChildren }) {
  return (
    <section class="start" aria-live="polite">
      <div>
        <h1>{title}</h1>
        {children}
        {code && <p class="code">{code}</p>}
      </div>
    </section>
  );
}
