// Two drapes side by side. One camera: who turns one turns both.

import { effect, useComputed, useSignal, type ReadonlySignal, type Signal } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { useCommands } from '../commands/context';
import type { AppState } from '../state/AppState';
import { BodySurface } from '../state/BodySurface';
import { grainsOf, mapOf, measured, ofOneScale, type ClothMap, type MapKind } from '../state/clothMaps';
import { comparedOf, type Compared, type ComparedDrape } from '../state/comparison';
import { useAppState } from '../state/context';
import { isKept, keptValues, missingInBoth, missingMaps, type MissingMaps } from '../state/keptMaps';
import { LiveCloth } from '../state/LiveCloth';
import type { Pose } from './framing';
import { Legend, MapSelect } from './MapLegend';
import { kViews, nudgeByKey, type ScenePaneProps } from './ScenePane';
import type { SceneView } from './SceneView';
import { paintByTheme, token } from './theme';
import { t } from '../texts/language';
import { Told } from '../texts/Message';

/** The two views, as they come; each takes the pose of the other. */
class Pair {
  private readonly views_: SceneView[] = [];

  add(view: SceneView): () => void {
    this.views_.push(view);
    view.listenToTurns((pose: Pose) => this.views_.forEach((other) => other !== view && other.follow(pose)));
    return () => void this.views_.splice(this.views_.indexOf(view), 1);
  }
}

/** One measurement of each, with one scale. */
function useMaps(left: ComparedDrape | null, right: ComparedDrape | null, kind: MapKind | null): (ClothMap | null)[] {
  const files = useAppState().mapFiles.value;
  return useMemo(() => {
    const mapped = [left, right].map((drape) => {
      if (!kind || !drape) return null;
      if (isKept(kind)) {
        const file = files.get(drape.job.id);
        const kept = file && keptValues(kind, file, drape.topology);
        return kept ? mapOf(kind, kept) : null;
      }
      const surface = (): BodySurface | null =>
        drape.body && drape.body.indices.length > 0 ? new BodySurface(drape.body) : null;
      const values = measured(kind, drape, grainsOf(drape.pieces), surface);
      return values && mapOf(kind, values);
    });
    return ofOneScale(mapped);
  }, [left, right, kind, files]);
}

const missingOf = (drape: ComparedDrape | null): MissingMaps => missingMaps(drape?.job ?? null, !drape?.body || drape.body.indices.length === 0);

export function ComparePane({ code }: Pick<ScenePaneProps, 'code'>) {
  const { comparison } = useAppState();
  const commands = useCommands();
  const pair = useMemo(() => new Pair(), []);
  const { left, right, mapKind } = comparison;
  const maps = useMaps(comparedOf(left.value), comparedOf(right.value), mapKind.value);
  const missing = missingInBoth(...([left, right].map((side) => missingOf(comparedOf(side.value))) as [MissingMaps, MissingMaps]));
  const legend = maps.find((map) => map !== null);
  return (
    <section class="scene" aria-label={t.scene.twoDrapes}>
      {[left, right].map((side, i) => (
        <Half key={i} code={code} pair={pair} side={side} map={maps[i]!} name={i === 0 ? t.scene.left : t.scene.right} />
      ))}
      <div class="scene-tools" role="toolbar" aria-label={t.scene.views}>
        {kViews.map(({ view }) => (
          <button key={view} class="tool" aria-label={t.scene.viewNames[view]} onClick={() => commands.showView(view)}>
            {t.scene.views_[view]}
          </button>
        ))}
        <MapSelect mapKind={mapKind} missing={missing} />
      </div>
      {legend && <Legend map={legend} pointed={NaN} />}
    </section>
  );
}

interface HalfProps extends Pick<ScenePaneProps, 'code'> {
  pair: Pair;
  side: ReadonlySignal<Compared | null>;
  map: ClothMap | null;
  name: string;
}

function Half({ code, pair, side, map, name }: HalfProps) {
  const shown = useComputed(() => comparedOf(side.value));
  const { canvas, scene, failed } = useStage(code, pair, shown);
  useEffect(() => scene.value?.setMap(map), [map, scene.value]);
  const job = shown.value?.job;
  const now = side.value;
  return (
    <div class="scene-half">
      <div class="scene-canvas">
        <canvas
          ref={canvas}
          tabIndex={0}
          onKeyDown={(event) => nudgeByKey(event, scene.value)}
          aria-label={t.scene.halfHint(name)}
        />
      </div>
      {job && (
        <a class="scene-caption" href={`#/jobs/${job.id}`}>
          <b>{job.name}</b>
          <span>{t.frame.revision(job.project_revision)}</span>
          <em>{t.scene.open}</em>
        </a>
      )}
      {now?.state === 'loading' && (
        <div class="scene-message quiet" role="status">
          <span class="spinner" aria-hidden="true" />
          <p>{t.scene.fetching}</p>
        </div>
      )}
      {now?.state === 'failed' && (
        <div class="scene-message" role="alert">
          <h2>{t.scene.cannotShow}</h2>
          <p>
            <Told code={now.error.code} detail={now.error.detail} /> <span class="code">{now.error.code}</span>
          </p>
        </div>
      )}
      {failed.value && <p class="scene-message">{t.scene.noWebgl} {failed.value}</p>}
    </div>
  );
}

/** A 3D view on the canvas, until the half goes. */
function useStage(code: ScenePaneProps['code'], pair: Pair, shown: ReadonlySignal<ComparedDrape | null>) {
  const state = useAppState();
  const commands = useCommands();
  const canvas = useRef<HTMLCanvasElement>(null);
  const scene: Signal<SceneView | null> = useSignal(null);
  const failed = useSignal('');
  useEffect(() => {
    let gone = false;
    const stops: (() => void)[] = [];
    code
      .then(({ SceneView }) => {
        if (gone || !canvas.current) return;
        const live = new LiveCloth();
        const view = new SceneView(canvas.current, live, { state, commands }, () => undefined, token('--accent-3d'));
        stops.push(pair.add(view), paintByTheme(view), () => view.dispose(), ...follow(view, live, shown, state));
        scene.value = view;
      })
      .catch((error: unknown) => (failed.value = error instanceof Error ? error.message : String(error)));
    return () => {
      gone = true;
      stops.reverse().forEach((stop) => stop());
      scene.value = null;
    };
  }, [code, pair, shown, state, commands, scene, failed]);
  return { canvas, scene, failed };
}

/** The view shows what the half has, and looks where it is asked to, until stopped. */
function follow(
  view: SceneView,
  live: LiveCloth,
  shown: ReadonlySignal<ComparedDrape | null>,
  state: AppState,
): (() => void)[] {
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const turn = state.view.peek().turn;
  return [
    effect(() => {
      const drape = shown.value;
      live.clear();
      view.setBody(drape?.body ?? null);
      view.show(Boolean(drape?.body), false);
      if (!drape) return;
      view.setLooks(drape.looks);
      view.setFinishes(drape.finishes);
      live.setTopology(drape.topology);
      live.setPositions(drape.positions, { epoch: 0, seq: 1, step: 0, time: 0 });
    }),
    effect(() => {
      if (state.view.value.turn > turn) view.look(state.view.value.view, calm.matches);
    }),
  ];
}
