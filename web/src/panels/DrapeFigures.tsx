// The drape under way: how it calms down, and what it is made of.

import type { Job } from '../api/types';
import { valueOf, type Sample } from '../state/AppState';
import { useAppState } from '../state/context';
import { fabricTitle } from '../state/fabrics';
import { isActive } from '../state/jobs';
import { cssColour } from '../state/patternGeometry';
import { versionOf } from '../state/versions';
import { count, duration, seconds, speed } from '../state/words';
import { OutcomeList } from './OutcomeList';
import { PinList } from './PinList';
import { SectionPanel } from './SectionPanel';
import { SolverField } from './SolverField';
import { t } from '../texts/language';

export function DrapeFigures() {
  const state = useAppState();
  const job = state.job.value;
  return (
    <>
      <OutcomeList />
      {job && <Speed samples={state.history.value} job={job} />}
      <PinList />
      <SectionPanel />
      {job && <Facts job={job} />}
      <SolverField />
      <Parts />
    </>
  );
}

const kWidth = 300;
const kHeight = 92;
/** Speeds of the axis, m/s: from hardly moving to falling. */
const kSlow = 1e-3;
const kFast = 3;
/** The document's usual settle_speed_mm_s. */
const kSettled = 5e-3;

const levelOf = (metresPerSecond: number): number => {
  const clamped = Math.min(kFast, Math.max(kSlow, metresPerSecond));
  return kHeight * (1 - Math.log(clamped / kSlow) / Math.log(kFast / kSlow));
};

/** Speed over simulated time, both ends of a logarithmic axis, with the line under which cloth counts as at rest. */
function Speed({ samples, job }: { samples: Sample[]; job: Job }) {
  if (samples.length < 2) {
    return isActive(job.state) ? (
      <div class="chart empty">
        <p>{t.drape.speedHere}</p>
      </div>
    ) : null;
  }
  const end = Math.max(samples[samples.length - 1]!.t, 1);
  const line = samples
    .map(({ t, speed: v }, i) => `${i === 0 ? 'M' : 'L'}${((kWidth * t) / end).toFixed(1)} ${levelOf(v).toFixed(1)}`)
    .join('');
  const last = samples[samples.length - 1]!;
  return (
    <figure class="chart">
      <figcaption>
        <span>{t.drape.speedOf}</span>
        <b>{speed(last.speed)}</b>
      </figcaption>
      <svg
        viewBox={`0 0 ${kWidth} ${kHeight}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={t.drape.speedNow(speed(last.speed))}
      >
        {[0.01, 0.1, 1].map((v) => (
          <path key={v} class="chart-grid" d={`M0 ${levelOf(v)}H${kWidth}`} />
        ))}
        <path class="chart-rest" d={`M0 ${levelOf(kSettled)}H${kWidth}`} />
        <path
          class="chart-area"
          d={`${line}L${((kWidth * last.t) / end).toFixed(1)} ${kHeight}H${((kWidth * samples[0]!.t) / end).toFixed(1)}Z`}
        />
        <path class="chart-line" d={line} />
      </svg>
      <div class="chart-axis">
        <span>{seconds(0, 0)}</span>
        <span class="chart-note">{t.drape.dashed}</span>
        <span>{seconds(end, 1)}</span>
      </div>
    </figure>
  );
}

function Facts({ job }: { job: Job }) {
  const state = useAppState();
  const topology = useTopologyFacts();
  const started = job.started_ms ?? 0;
  const until = job.ended_ms || (isActive(job.state) ? state.now.value : started);
  const version = versionOf(state.versions.list.value, job.id);
  const rows: [string, string][] = [
    [t.drape.facts.drape, job.id],
    [t.drape.facts.revision, String(job.project_revision)],
    ...(version ? [[t.drape.facts.version, version.name] as [string, string]] : []),
    ...(started ? [[t.drape.facts.running, duration(Math.max(0, until - started) / 1000)] as [string, string]] : []),
    ...topology,
  ];
  return (
    <dl class="facts">
      {rows.map(([term, value]) => (
        <div key={term}>
          <dt>{term}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

function useTopologyFacts(): [string, string][] {
  const state = useAppState();
  void state.progress.value; // the topology is not a signal; figures come with the first progress at the latest
  const topology = state.cloth.topology;
  if (!topology) return [];
  
  return [
    [t.drape.facts.particles, count(topology.vertexCount)],
    [t.drape.facts.triangles, count(topology.triangles.length / 3)],
  ];
}

/** Fabrics and the pieces cut from them; a click selects. */
function Parts() {
  const state = useAppState();
  const pieces = valueOf(state.pieces.value ?? { state: 'loading' });
  if (!pieces) return null;
  const fabrics = [...new Set(pieces.pieces.map((piece) => piece.fabric))];
  return (
    <div class="parts">
      {fabrics.map((fabric) => (
        <div key={fabric}>
          <h3>{fabricTitle(fabric, state.editing.fabrics.value, state.editing.ownFabrics.value) || t.fabric.fabric}</h3>
          <ul>
            {pieces.pieces
              .filter((piece) => piece.fabric === fabric)
              .map((piece) => (
                <li key={piece.id}>
                  <button
                    class="part"
                    aria-pressed={state.selected.value === piece.id}
                    onClick={() => (state.selected.value = state.selected.value === piece.id ? null : piece.id)}
                    onPointerEnter={() => (state.hovered.value = piece.id)}
                    onPointerLeave={() => (state.hovered.value = null)}
                  >
                    <i style={{ background: cssColour(piece.colour) }} aria-hidden="true" />
                    {piece.id}
                  </button>
                </li>
              ))}
          </ul>
        </div>
      ))}
    </div>
  );
}
