// Puts the page together: makes the state, connects it with the service, draws the panels.

import { computed, effect, untracked } from '@preact/signals';
import { render, type JSX } from 'preact';
import { makeApi } from './api/Api';
import { makeDressingApi } from './api/dressing';
import { ClothStream, type WorkerPort } from './api/ClothStream';
import { Commands } from './commands/Commands';
import { Comparer } from './commands/Comparer';
import { CommandsContext } from './commands/context';
import { MapKeeper } from './commands/MapKeeper';
import { Poller } from './commands/Poller';
import { SectionKeeper } from './commands/SectionKeeper';
import { WarmEdits } from './commands/WarmEdits';
import { Watcher } from './commands/Watcher';
import { ImportPreview } from './pattern/ImportPreview';
import { PatternPane } from './pattern/PatternPane';
import { Banner } from './panels/Banner';
import { ComparisonPanel } from './panels/ComparisonPanel';
import { DropTarget } from './panels/DropTarget';
import { HelpDialog } from './panels/HelpDialog';
import { Inspector } from './panels/Inspector';
import { IntakeDialog } from './panels/IntakeDialog';
import { LogIn } from './panels/LogIn';
import { Notices } from './panels/Notices';
import { Rail } from './panels/Rail';
import { ShareDialog } from './panels/ShareDialog';
import { Splitter } from './panels/Splitter';
import { StartPage } from './panels/StartPage';
import { StatusBar } from './panels/StatusBar';
import { SweepDialog } from './panels/SweepDialog';
import { AdminPanel } from './panels/AdminPanel';
import { SweepPanel } from './panels/SweepPanel';
import { TopBar } from './panels/TopBar';
import { Tour } from './panels/Tour';
import { ComparePane } from './scene/ComparePane';
import { ScenePane } from './scene/ScenePane';
import { AppState } from './state/AppState';
import { StateContext } from './state/context';
import { positionsHash } from './state/LiveCloth';
import { formatRoute, parseRoute, type Route } from './state/routes';
import { listenForKeys } from './tools/keys';
import { t } from './texts/language';

// Begins to fetch three.js beside everything else; nothing waits for it but the 3D view.
const sceneCode = import('./scene/SceneView');
sceneCode.catch(() => undefined);

const api = makeApi();
const state = new AppState();
const port = new Worker(new URL('./workers/stream.worker.ts', import.meta.url), {
  type: 'module',
}) as unknown as WorkerPort;

const poller = new Poller(state, api, () => {
  watcher.retry();
  commands.dressing.retry();
});
const refresh = (): void => void poller.refresh();
// The worker answers only after this file has run, so that the watcher is there by then.
const stream: ClothStream = new ClothStream(port, {
  connection: (connection) => handlers.connection(connection),
  text: (message) => handlers.text(message),
  topology: (topology) => handlers.topology(topology),
  frame: (positions, moment) => handlers.frame(positions, moment),
});
const watcher: Watcher = new Watcher(state, api, stream, refresh, (id) => go(formatRoute({ name: 'job', id }), true));
const handlers = watcher.handlers();

function go(hash: string, replace: boolean): void {
  if (replace) history.replaceState(null, '', hash);
  else history.pushState(null, '', hash);
  state.route.value = parseRoute(location.hash);
}

function save(name: string, text: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type: 'application/json' }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** randomUUID is missing where the page does not come from this machine or by https. */
const newKey = (): string =>
  Array.from(crypto.getRandomValues(new Uint8Array(16)), (b) => b.toString(16).padStart(2, '0')).join('');

const anew = (): void => location.reload();

const commands = new Commands(state, api, { go, save, newKey, anew, say: (word) => stream.say(word), follow: (id) => watcher.follow(id) }, refresh, (id) => watcher.show(id));

/** What the page test looks through. */
const hook = { drawn: 0, firstDrawnMs: 0 };
function drawn(): void {
  hook.drawn += 1;
  hook.firstDrawnMs ||= performance.now();
}

/** Asks for everything at once, without waiting for the next turn. */
function retry(): void {
  refresh();
  stream.poke();
}

/** Two drapes with one camera, and their figures. */
function Comparison() {
  return (
    <main class="comparing">
      <h1 class="visually-hidden">{t.frame.twoCompared}</h1>
      <ComparePane code={sceneCode} />
      <ComparisonPanel />
      <StartPage resultUrl={api.resultUrl} />
    </main>
  );
}

/** One garment on several bodies and of several fabrics. */
function Sweep() {
  return (
    <main class="sweeping">
      <SweepPanel resultUrl={api.resultUrl} sweeps={api} />
    </main>
  );
}

/** The service for whoever runs it. */
function Service() {
  return (
    <main class="serving">
      <AdminPanel />
    </main>
  );
}

/** What is shown in place of the drape and what is worked with. */
const kOwnPages: Partial<Record<Route['name'], () => JSX.Element>> = {
  compare: Comparison,
  sweep: Sweep,
  admin: Service,
};

/** The drape beside what is worked with, or beside the first page. */
function Main() {
  const Own = kOwnPages[state.route.value.name];
  if (Own) return <Own />;
  const home = state.atHome.value;
  const large = state.editing.large.value ? ' pattern-large' : '';
  const shape = home ? `home${state.job.value ? '' : ' alone'}` : `at-${state.tab.value}${large}`;
  return (
    <main class={shape}>
      {!home && <h1 class="visually-hidden">{state.project.value?.name ?? state.job.value?.name ?? 'Toile'}</h1>}
      <ScenePane code={sceneCode} drawn={drawn} />
      {!home && (
        <>
          <Splitter />
          <div class="side">
            <PatternPane />
            <Inspector resultUrl={api.resultUrl} movies={api} files={api} />
          </div>
        </>
      )}
      <StartPage resultUrl={api.resultUrl} />
    </main>
  );
}

function Page() {
  return (
    <StateContext.Provider value={state}>
      <CommandsContext.Provider value={commands}>
        <div class={`page${state.railShown.value ? '' : ' rail-hidden'}`}>
          <TopBar />
          <Banner retry={retry} />
          {state.railShown.value && <Rail resultUrl={api.resultUrl} />}
          <Main />
          <StatusBar />
          <Notices />
          <IntakeDialog Preview={ImportPreview} />
          <Tour />
          <HelpDialog />
          <ShareDialog links={api} />
          <SweepDialog />
          <LogIn doors={api} entered={anew} />
          <DropTarget />
        </div>
      </CommandsContext.Provider>
    </StateContext.Provider>
  );
}

window.addEventListener('hashchange', () => (state.route.value = parseRoute(location.hash)));
window.addEventListener('popstate', () => (state.route.value = parseRoute(location.hash)));
window.addEventListener('online', retry);
document.addEventListener('visibilitychange', () => document.visibilityState === 'visible' && refresh());
setInterval(() => (state.now.value = Date.now()), 1000);

state.route.value = parseRoute(location.hash);
listenForKeys(commands, state);
watcher.start();
new Comparer(state, api).start();
commands.sweeps.start();
commands.admin.start();
commands.versions.start();
new MapKeeper(state, (job, name) => api.resultText(job, name)).start();
new SectionKeeper(state, makeDressingApi()).start();
effect(() => {
  if (state.atWork.value) untracked(() => commands.tours.greet());
});
effect(() => {
  void state.projectId.value;
  untracked(() => commands.pattern.projectChanged());
});
const revision = computed(() => state.project.value?.revision ?? 0);
effect(() => {
  const id = state.projectId.value;
  if (!state.beforeDrape.value && id !== null) return;
  const newest = revision.value;
  untracked(() => void commands.dressing.load(id, newest));
});
effect(() => {
  const id = state.projectId.value;
  if (id && revision.value > 0) untracked(() => void commands.edits.loadHistory(id));
});
effect(() => {
  void state.pieces.value;
  void state.seenPieces.value;
  void state.project.value;
  untracked(() => void commands.textures.follow());
  // They tell how light plays on the cloth.
  if (state.pieces.value?.state === 'ready') untracked(() => void commands.pattern.loadFabrics());
});
new WarmEdits(state, () => commands.goOn()).start();
effect(() => {
  const named = state.job.value?.name ?? state.project.value?.name;
  const shown = state.route.value.name === 'admin' ? t.admin.open : state.atHome.value ? '' : named;
  document.title = shown ? `${shown} · Toile` : 'Toile';
});
refresh();
void commands.lookWhoAsks();
render(<Page />, document.getElementById('page')!);

Object.assign(window, {
  __toile: {
    job: () => state.job.value,
    project: () => state.project.value,
    route: () => formatRoute(state.route.value),
    link: () => state.link.value.state,
    stream: () => state.stream.value.state,
    moment: () => state.cloth.moment,
    frames: () => state.cloth.frames,
    drawn: () => hook.drawn,
    firstDrawnMs: () => hook.firstDrawnMs,
    map: () => state.clothMap.value,
    section: () => state.section.cut.value,
    looks: () => [...state.looks.value.keys()],
    start: () => state.dressing.start.value?.positions.length ?? 0,
    startHash: () => (state.dressing.start.value ? positionsHash(state.dressing.start.value.positions) : ''),
    bodyHash: () => (state.shownBody.value ? positionsHash(state.shownBody.value.positions) : ''),
    dressing: () => state.dressing.bodies.value,
    check: () => state.dressing.check.value,
    positions: () => Array.from(state.cloth.positions ?? []),
    positionsHash: () => (state.cloth.positions ? positionsHash(state.cloth.positions) : ''),
  },
});
