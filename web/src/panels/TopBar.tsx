// Name of what is shown, and what can be done with it.

import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { mayRun } from '../state/admin';
import { commandsOf, isActive } from '../state/jobs';
import { Icon } from '../controls/Icon';
import { BrandMark } from '../controls/BrandMark';
import { StateChip } from './StateChip';
import { t } from '../texts/language';
import { Settings } from './Settings';

export function TopBar() {
  const state = useAppState();
  const home = state.atHome.value;
  return (
    <header class="topbar">
      <button
        class="tool flat"
        aria-pressed={state.railShown.value}
        title={t.frame.projectListKey}
        aria-label={t.frame.projectList}
        onClick={() => (state.railShown.value = !state.railShown.value)}
      >
        <Icon name="list" />
      </button>
      <a class="brand" href="#/" aria-label={t.frame.toStart}>
        <BrandMark />
      </a>
      <div class="crumbs">{!home && <Crumbs />}</div>
      {!home && <Actions />}
      {mayRun(state.session.value) && (
        <a class="plain" href="#/admin" title={t.admin.openTip} aria-current={state.route.value.name === 'admin' ? 'page' : undefined}>
          <Icon name="gauge" /> <span class="label">{t.admin.open}</span>
        </a>
      )}
      {state.session.value?.accounts && <LogOut name={state.session.value.name ?? ''} />}
      <Settings />
      <button
        class="tool flat keys-open"
        title={t.frame.keysTip}
        aria-label={t.frame.shortcuts}
        onClick={() => (state.helpShown.value = true)}
      >
        <Icon name="help" />
      </button>
    </header>
  );
}

/** Who is known, where there are accounts. */
function LogOut({ name }: { name: string }) {
  const commands = useCommands();
  return (
    <button class="plain who" aria-label={t.frame.logOutWho(name)} title={t.frame.logOut} onClick={() => void commands.logOut()}>
      {name} <Icon name="leave" />
    </button>
  );
}

/** The project and the state of its drape. */
function Crumbs() {
  const state = useAppState();
  const project = state.project.value;
  const job = state.job.value;
  return (
    <>
      {project && (
        <a class="crumb" href={`#/projects/${project.id}`} title={t.frame.project}>
          {project.name}
        </a>
      )}
      {!project && job && <span class="crumb">{job.name}</span>}
      {job?.sweep && (
        <>
          <span class="crumb-sep" aria-hidden="true">
            /
          </span>
          <a class="crumb" href={`#/sweeps/${job.sweep.id}`}>
            {t.sweep.one}
          </a>
        </>
      )}
      {job && (
        <>
          <span class="crumb-sep" aria-hidden="true">
            /
          </span>
          <StateChip state={job.state} />
        </>
      )}
    </>
  );
}

/** Ways to dialogs about what is shown. */
function Dialogs({ offline }: { offline: boolean }) {
  const { projectId, job, sweeps, sharing } = useAppState();
  return (
    <>
      {projectId.value && (
        <button class="plain sweep-open" disabled={offline} onClick={() => (sweeps.choosing.value = true)} title={t.sweep.openTip}>
          <Icon name="grid" /> <span class="label">{t.sweep.open}</span>
        </button>
      )}
      {job.value && (
        <button class="plain" disabled={offline} onClick={() => (sharing.value = true)} title={t.frame.shareTip}>
          <Icon name="share" /> <span class="label">{t.frame.share}</span>
        </button>
      )}
    </>
  );
}

/** Of a drape that is paused: by one frame, or from here on. */
function GoOn({ offline }: { offline: boolean }) {
  const commands = useCommands();
  return (
    <>
      <button class="plain" aria-label={t.frame.step} disabled={offline} onClick={() => void commands.act('step')} title={t.frame.stepKey}>
        <Icon name="step" /> <span class="label">{t.frame.step}</span>
      </button>
      <button class="primary" disabled={offline} onClick={() => void commands.act('resume')} title={t.frame.resumeKey}>
        <Icon name="play" /> {t.frame.resume}
      </button>
    </>
  );
}

/** Of a drape that has not ended. */
function UnderWay({ offline }: { offline: boolean }) {
  const commands = useCommands();
  const can = commandsOf(useAppState().job.value?.state ?? 'cancelled');
  return (
    <>
      {can.cancel && (
        <button class="plain" aria-label={t.common.cancel} disabled={offline} onClick={() => void commands.act('cancel')}>
          <Icon name="stop" /> <span class="label">{t.common.cancel}</span>
        </button>
      )}
      {can.pause && (
        <button class="plain" disabled={offline} onClick={() => void commands.act('pause')} title={t.frame.pauseKey}>
          <Icon name="pause" /> {t.frame.pause}
        </button>
      )}
      {can.resume && <GoOn offline={offline} />}
    </>
  );
}

function Actions() {
  const state = useAppState();
  const commands = useCommands();
  const job = state.job.value;
  const offline = state.link.value.state === 'lost';
  const active = job !== null && isActive(job.state);
  return (
    <div class="actions">
      <Dialogs offline={offline} />
      <UnderWay offline={offline} />
      {!active && state.projectId.value && !job?.sweep && (
        <button
          class="primary"
          disabled={offline || state.submitting.value}
          onClick={() => void commands.startDrape()}
          title={t.frame.startKey}
        >
          <Icon name="play" /> {job ? t.common.drapeAgain : t.common.startDrape}
        </button>
      )}
    </div>
  );
}
