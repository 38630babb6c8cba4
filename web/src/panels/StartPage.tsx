// What stands where the work will be when there is none to show: a first visit, an address that leads nowhere, no service.

import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { Icon } from '../controls/Icon';

/** Null where there is something to show. */
export function StartPage() {
  const state = useAppState();
  const commands = useCommands();
  const route = state.route.value;
  const { projects, jobs } = state;
  if (projects.value.state === 'failed' && jobs.value.state === 'failed') {
    return (
      <Sheet title="The server does not answer" code={projects.value.error.code}>
        <p>
          The page is here, but the service behind it is not. It is asked again by itself; when it runs, everything
          appears.
        </p>
        <p>
          On this machine <code>./run</code> starts it.
        </p>
      </Sheet>
    );
  }
  if (projects.value.state !== 'ready' || jobs.value.state !== 'ready') return null;
  const lost =
    route.name === 'unknown' ||
    (route.name === 'job' && !state.job.value) ||
    (route.name === 'project' && !state.project.value);
  if (lost) {
    return (
      <Sheet title="Nothing is here" code={location.hash}>
        <p>This drape or project does not exist, or no longer does.</p>
        <p>
          <a class="button primary" href="#/">
            To the newest drape
          </a>
        </p>
      </Sheet>
    );
  }
  if (projects.value.value.length > 0 || jobs.value.value.length > 0) return null;
  return (
    <Sheet title="Drape your first garment">
      <p>
        Drop a <b>DXF</b> pattern anywhere on this page. Toile reads its pieces, proposes the seams, stands them around
        a body and lets the cloth hang, here before your eyes.
      </p>
      <p>
        <button class="primary" onClick={() => commands.openIntake()}>
          <Icon name="plus" /> New project
        </button>
      </p>
    </Sheet>
  );
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
