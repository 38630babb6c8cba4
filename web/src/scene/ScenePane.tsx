// The 3D view's place on the page: its canvas, its buttons, and what is said while there is nothing to show.

import { effect, useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import type { Job } from '../api/types';
import { useCommands } from '../commands/context';
import type { AppState, View } from '../state/AppState';
import { useAppState } from '../state/context';
import { activity, isActive, overall, placeInQueue } from '../state/jobs';
import { capital, percent } from '../state/words';
import { sceneTools } from '../tools/table';
import { HandHint, HandTools } from './HandTools';
import { paintByTheme, token } from './theme';
import { MapChoice, MapLegend } from './MapLegend';
import type { SceneView } from './SceneView';
import { t } from '../texts/language';

export const kViews: { view: View; key: string }[] = [
  { view: 'front', key: '1' },
  { view: 'back', key: '2' },
  { view: 'side', key: '3' },
  { view: 'three-quarter', key: '4' },
];

const kNudges: Record<string, [number, number, number]> = {
  arrowleft: [-10, 0, 1],
  arrowright: [10, 0, 1],
  arrowup: [0, 6, 1],
  arrowdown: [0, -6, 1],
  '+': [0, 0, 0.88],
  '=': [0, 0, 0.88],
  '-': [0, 0, 1.14],
};

/** Arrow keys turn, plus and minus zoom. */
export function nudgeByKey(event: KeyboardEvent, scene: SceneView | null): void {
  const nudge = kNudges[event.key.toLowerCase()];
  if (!nudge) return;
  event.preventDefault();
  scene?.nudge(...nudge);
}

export interface ScenePaneProps {
  /** The 3D code, which is fetched while the page is drawn. */
  code: Promise<typeof import('./SceneView')>;
  drawn: () => void;
  /** What is said over the stage, in place of the page's own words and ways out. */
  told?: ComponentChildren;
}

/** The 3D view on the canvas, from when its code is there until the pane goes; and why there is none. */
function useScene({ code, drawn }: ScenePaneProps) {
  const state = useAppState();
  const commands = useCommands();
  const canvas = useRef<HTMLCanvasElement>(null);
  const scene = useRef<SceneView | null>(null);
  const failed = useSignal('');
  useEffect(() => {
    let gone = false;
    let stop = (): void => undefined;
    code
      .then(({ SceneView }) => {
        if (gone || !canvas.current) return;
        scene.current = new SceneView(canvas.current, state.cloth, { state, commands }, drawn, token('--accent-3d'));
        stop = connect(scene.current, state);
      })
      .catch((error: unknown) => (failed.value = error instanceof Error ? error.message : String(error)));
    return () => {
      gone = true;
      stop();
      scene.current?.dispose();
    };
  }, [code, drawn, state, commands, failed]);
  return { canvas, scene, failed };
}

export function ScenePane(props: ScenePaneProps) {
  const { canvas, scene, failed } = useScene(props);
  return (
    <section class="scene" aria-label={t.scene.title}>
      <div class="scene-canvas">
        <canvas
          ref={canvas}
          tabIndex={0}
          onKeyDown={(event) => nudgeByKey(event, scene.current)}
          aria-label={t.scene.canvas}
        />
      </div>
      {failed.value ? (
        <Message title={t.scene.no3d} text={t.scene.noWebglBecause(failed.value)} />
      ) : (
        (props.told ?? <Overlay />)
      )}
      <Busy />
      <div class="scene-top">
        <ViewTools hands={props.told === undefined} />
        {props.told === undefined && <HandHint />}
        <MapLegend />
      </div>
    </section>
  );
}

/** From where it is seen, and what is shown. */
function ViewTools({ hands }: { hands: boolean }) {
  const { bodyShown, meshShown } = useAppState();
  const commands = useCommands();
  return (
    <div class="scene-tools" role="toolbar" aria-label={t.scene.views}>
      <span class="scene-views">
        {kViews.map(({ view, key }) => (
          <button
            key={view}
            class="tool"
            onClick={() => commands.showView(view)}
            title={`${capital(t.scene.viewNames[view])} (${key})`}
            aria-label={t.scene.viewNames[view]}
          >
            {t.scene.views_[view]}
          </button>
        ))}
      </span>
      <span class="tool-gap" />
      <Toggle on={bodyShown.value} title={t.scene.bodyKey} label={t.scene.body} flip={() => (bodyShown.value = !bodyShown.value)} />
      <Toggle on={meshShown.value} title={t.scene.meshKey} label={t.scene.mesh} flip={() => (meshShown.value = !meshShown.value)} />
      <MapChoice />
      {hands && <HandTools />}
    </div>
  );
}

/** The view follows these parts of the state until stopped. */
function connect(scene: SceneView, state: AppState): () => void {
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const turn = state.view.peek().turn;
  const stops = [
    effect(() => scene.setBody(state.shownBody.value)),
    effect(() => scene.setStart(state.beforeDrape.value ? state.dressing.start.value : null)),
    effect(() => scene.setTools(state.atHome.value ? [] : sceneTools.filter((tool) => tool.isHeld(state)))),
    effect(() => scene.setPins(state.touchable.value ? (state.job.value?.progress?.pins ?? []) : [], state.hands.litPin.value)),
    effect(() => scene.setHeld(state.hands.held.value)),
    effect(() => scene.setFigures(state.beforeDrape.value ? (state.dressing.bodies.value ?? []) : [])),
    effect(() => scene.showMarks(state.shownMarks.value, state.dressing.lit.value)),
    effect(() => {
      const shown = state.beforeDrape.value ? state.dressing.finding.value : null;
      scene.lookAt(shown?.finding ?? null, calm.matches);
    }),
    effect(() => scene.show(state.bodyShown.value && state.shownBody.value !== null, state.meshShown.value)),
    effect(() => scene.setLooks(state.clothLooks.value)),
    effect(() => scene.setFinishes(state.finishes.value)),
    effect(() => scene.showOpenSeams(!state.beforeDrape.value && state.job.value?.state === 'succeeded', token('--bad'))),
    effect(() => scene.setMap(state.beforeDrape.value || state.atHome.value ? null : state.clothMap.value)),
    effect(() => scene.setSection(state.section.cut.value)),
    effect(() => scene.lightSeam(state.litParts.value)),
    effect(() => scene.highlight(state.selected.value, state.hovered.value)),
    effect(() => {
      if (state.view.value.turn > turn) scene.look(state.view.value.view, calm.matches);
    }),
    paintByTheme(scene),
  ];
  state.lookingFrom.value = () => scene.viewpoint;
  return () => {
    state.lookingFrom.value = null;
    stops.forEach((stop) => stop());
  };
}

/** A change of body or places under way. */
function Busy() {
  const { dressing } = useAppState();
  if (!dressing.busy.value) return null;
  return (
    <p class="scene-busy" role="status">
      <span class="spinner" aria-hidden="true" /> {dressing.busy.value}…
    </p>
  );
}

function Toggle({ on, title, label, flip }: { on: boolean; title: string; label: string; flip: () => void }) {
  return (
    <button class="tool" aria-pressed={on} title={title} onClick={flip}>
      {label}
    </button>
  );
}

function Message({ title, text, children }: { title: string; text: string; children?: preact.ComponentChildren }) {
  return (
    <div class={`scene-message${text ? '' : ' compact docked'}`}>
      <h2>{title}</h2>
      {text && <p>{text}</p>}
      {children}
    </div>
  );
}

/** What is said over an empty stage. Nothing as soon as there is cloth. */
function Overlay() {
  const state = useAppState();
  const job = state.job.value;
  if (state.atHome.value) return job && <Caption job={job} />;
  if (state.outdated.value && !state.beforeDrape.value) return <Outdated />;
  if (state.covered.value) return state.since.value && !state.beforeDrape.value ? <Older /> : null;
  if (job) return <WithoutCloth job={job} />;
  return state.route.value.name === 'project' && state.project.value ? <NotDraped /> : null;
}

/** On the first page: what is seen there, and the way to it. */
function Caption({ job }: { job: Job }) {
  const done = job.progress ? overall(job.progress.phase, job.progress.fraction) : 0;
  const doing = activity(job.state, job.progress?.phase);
  return (
    <a class="scene-caption" href={`#/jobs/${job.id}`}>
      <b>{job.name}</b>
      <span class={`state-${job.state}`}>
        <i class="dot" aria-hidden="true" />
        {isActive(job.state) ? `${doing} · ${percent(done, 0)}` : doing}
      </span>
      <em>{t.scene.open}</em>
    </a>
  );
}

function WithoutCloth({ job }: { job: Job }) {
  const state = useAppState();
  if (job.state === 'queued') return <Waiting ahead={placeInQueue(state.allJobs.value, job.id)} />;
  if (isActive(job.state)) {
    return (
      <div class="scene-message quiet" role="status">
        <span class="spinner" aria-hidden="true" />
        <p>{activity(job.state, job.progress?.phase)}…</p>
      </div>
    );
  }
  if (job.state === 'failed') return <Ended title={t.scene.failed} text={t.scene.whereBegan} />;
  if (job.state === 'cancelled') return <Ended title={t.scene.cancelled} text={t.scene.whereBegan} />;
  return null;
}

/** What is seen is no longer what the pattern says. */
function Older() {
  const state = useAppState();
  const commands = useCommands();
  return (
    <div class="scene-message strip docked older" role="status">
      <p>{t.scene.changed}</p>
      <button class="plain" disabled={state.submitting.value} onClick={() => void commands.startDrape()}>
        {t.common.drapeAgain}
      </button>
    </div>
  );
}

/** The drape under way is of the pattern as it was; what it may go on with by itself is taken over at once. */
function Outdated() {
  const state = useAppState();
  const commands = useCommands();
  return (
    <div class={`scene-message strip${state.goesOnWarm.value ? '' : ' docked'}`} role="status">
      <p>{state.goesOnWarm.value ? t.scene.takesOver : t.scene.changed}</p>
      {!state.goesOnWarm.value && (
        <button class="plain" disabled={state.submitting.value} onClick={() => void commands.goOn()}>
          {t.scene.takeOver}
        </button>
      )}
    </div>
  );
}

/** A drape without cloth to show: the panel beside says why, and what to do. */
function Ended({ title, text }: { title: string; text: string }) {
  const { tab } = useAppState();
  return (
    <div class="scene-message strip docked">
      <h2>{title}</h2>
      <p>{text}</p>
      {tab.value !== 'drape' && (
        <button class="plain" onClick={() => (tab.value = 'drape')}>
          {t.scene.why}
        </button>
      )}
    </div>
  );
}

function Waiting({ ahead }: { ahead: number }) {
  const next = t.scene.next;
  return <Message title={t.scene.inQueue} text={ahead === 0 ? next : t.scene.before(ahead)} />;
}

function NotDraped() {
  const state = useAppState();
  const commands = useCommands();
  return (
    <Message
      title={t.common.notDraped}
      text={state.dressing.start.value ? '' : t.scene.readyToDrape}
    >
      <button class="primary" disabled={state.submitting.value} onClick={() => void commands.startDrape()}>
        {t.common.startDrape} <kbd>{t.keys.names.Space}</kbd>
      </button>
    </Message>
  );
}
