// Puts the page of a share link together. It asks for nothing but what the link shows.

import { effect } from '@preact/signals';
import { render } from 'preact';
import { makeApi } from './api/Api';
import { ClothStream, type WorkerPort } from './api/ClothStream';
import { makeSharedApi } from './api/links';
import { Commands } from './commands/Commands';
import { CommandsContext } from './commands/context';
import { MapKeeper } from './commands/MapKeeper';
import { SharedKeeper } from './commands/SharedKeeper';
import { SharedFrame, SharedTold } from './panels/SharedFrame';
import { ScenePane } from './scene/ScenePane';
import { AppState, valueOf } from './state/AppState';
import { StateContext } from './state/context';
import { positionsHash } from './state/LiveCloth';
import { parseRoute } from './state/routes';
import { SharedState } from './state/shared';

export function startShared(secret: string, root: HTMLElement): void {
  const sceneCode = import('./scene/SceneView');
  sceneCode.catch(() => undefined);
  const state = new AppState();
  const shared = new SharedState();
  const api = makeSharedApi();
  const port = new Worker(new URL('./workers/stream.worker.ts', import.meta.url), {
    type: 'module',
  }) as unknown as WorkerPort;
  const stream: ClothStream = new ClothStream(port, {
    connection: (connection) => handlers.connection(connection),
    text: (message) => handlers.text(message),
    topology: (topology) => handlers.topology(topology),
    frame: (positions, moment) => handlers.frame(positions, moment),
  });
  const keeper = new SharedKeeper(state, shared, api, stream);
  const handlers = keeper.handlers();
  const around = { go: () => undefined, save: () => undefined, newKey: () => '', anew: () => location.reload(), say: () => undefined, follow: () => undefined };
  // Views want commands; of these only those that turn the view are to be had here.
  const commands = new Commands(state, makeApi(), around, () => undefined, () => undefined);
  const hook = { drawn: 0 };
  const drawn = (): void => void (hook.drawn += 1);
  const again = (): void => void keeper.again();

  new MapKeeper(state, null).start();
  effect(() => {
    const job = valueOf(shared.job.value);
    document.title = job ? `${job.name} · Toile` : 'Toile';
  });
  window.addEventListener('online', () => (shared.job.value.state === 'failed' ? again() : stream.poke()));
  window.addEventListener('hashchange', () => {
    const route = parseRoute(location.hash);
    if (route.name !== 'shared' || route.secret !== secret) location.reload();
  });
  render(
    <StateContext.Provider value={state}>
      <CommandsContext.Provider value={commands}>
        <SharedFrame shared={shared} api={api} again={again}>
          <ScenePane code={sceneCode} drawn={drawn} told={<SharedTold shared={shared} />} />
        </SharedFrame>
      </CommandsContext.Provider>
    </StateContext.Provider>,
    root,
  );
  void keeper.open(secret);
  Object.assign(window, {
    __toile: {
      shared: () => valueOf(shared.job.value),
      body: () => state.body.value?.state ?? '',
      frames: () => state.cloth.frames,
      drawn: () => hook.drawn,
      stream: () => state.stream.value.state,
      looks: () => [...state.looks.value.keys()],
      positionsHash: () => (state.cloth.positions ? positionsHash(state.cloth.positions) : ''),
    },
  });
}
