// A sweep as a table of pictures, in rows of bodies and columns of fabrics. It fills as drapes end.

import type { SweepApi, Sweep, SweepCell, SweepFigures } from '../api/sweeps';
import { useEffect } from 'preact/hooks';
import { useCommands } from '../commands/context';
import { Icon } from '../controls/Icon';
import { useAppState } from '../state/context';
import { presetTitle } from '../state/dressing';
import { fabricTitle } from '../state/fabrics';
import { cellsOf, doneOf, easesOf, rowsOf, stretchOf, verdictOf } from '../state/sweeps';
import { duration, percent } from '../state/words';
import { t } from '../texts/language';
import { NotThere } from './NotThere';
import { Remove, type PicturesProps } from './Rail';

type Props = PicturesProps & { sweeps: Pick<SweepApi, 'sweepUrl'> };

export function SweepPanel({ resultUrl, sweeps }: Props) {
  const shown = useAppState().sweeps.shown.value;
  if (shown?.state !== 'ready') return <NotThere wanted={shown} loading={t.sweep.loading} />;
  return (
    <>
      <Head sweep={shown.value} sweeps={sweeps} />
      <Table sweep={shown.value} resultUrl={resultUrl} />
    </>
  );
}

function Head({ sweep, sweeps }: { sweep: Sweep; sweeps: Pick<SweepApi, 'sweepUrl'> }) {
  const commands = useCommands().sweeps;
  const [done, all] = [doneOf(sweep), cellsOf(sweep)];
  return (
    <header class="sweep-head">
      <div>
        <h1>{sweep.name}</h1>
        <p>
          {sweep.ended ? t.sweep.ended(all) : t.sweep.under(done, all)}
          {' · '}
          <a href={`#/projects/${sweep.project_id}`}>{t.sweep.project}</a>
        </p>
        {!sweep.ended && (
          <span class="bar" role="progressbar" aria-label={t.sweep.progress} aria-valuenow={Math.round(100 * sweep.fraction)}>
            <i style={{ width: `${100 * sweep.fraction}%` }} />
          </span>
        )}
      </div>
      <nav class="sweep-files" aria-label={t.common.takeOut}>
        {!sweep.ended && (
          <button class="plain" onClick={() => void commands.cancel(sweep.id)}>
            <Icon name="stop" /> {t.sweep.cancel}
          </button>
        )}
        <a class="button plain" href={sweeps.sweepUrl(sweep.id, 'sheet.png')} download={`${sweep.name}.png`}>
          <Icon name="down" /> {t.sweep.sheet}
        </a>
        <a class="button plain" href={sweeps.sweepUrl(sweep.id, 'table.csv')} download={`${sweep.name}.csv`}>
          <Icon name="down" /> {t.sweep.table}
        </a>
        {sweep.ended && <Remove what={t.sweep.theSweep(sweep.name)} remove={() => commands.remove(sweep.id)} />}
      </nav>
    </header>
  );
}

/** A size in the page's words, where it is one. */
const bodyTitle = (body: string): string => (/^(eu|m|child)\d+$/.test(body) ? presetTitle(body) : body);

function Table({ sweep, resultUrl }: { sweep: Sweep } & PicturesProps) {
  const { fabrics } = useAppState().editing;
  const { pattern } = useCommands();
  useEffect(() => void pattern.loadFabrics(), [pattern]);
  return (
    <div class="sweep-scroll" tabIndex={0} role="region" aria-label={t.sweep.cells}>
      <table class="sweep-table">
        <thead>
          <tr>
            <th scope="col">
              <span class="visually-hidden">{t.sweep.bodies}</span>
            </th>
            {sweep.fabrics.map((fabric) => (
              <th key={fabric} scope="col">
                {fabricTitle(fabric, fabrics.value)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rowsOf(sweep).map(({ body, cells }) => (
            <tr key={body}>
              <th scope="row">{bodyTitle(body)}</th>
              {cells.map((cell) => (
                <td key={cell.fabric}>
                  <Cell cell={cell} title={`${bodyTitle(body)}, ${fabricTitle(cell.fabric, fabrics.value)}`} resultUrl={resultUrl} />
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** Pixels: twice as wide as it is shown, for fine screens. */
const kStillWidth = 400;

function Cell({ cell, title, resultUrl }: { cell: SweepCell; title: string } & PicturesProps) {
  const { word, verdict } = verdictOf(cell);
  const active = cell.state === 'running' || cell.state === 'paused';
  const shown = (
    <>
      <span class={`sweep-still state-${cell.state}`}>
        {cell.job && cell.pictured ? (
          <img src={resultUrl(cell.job, 'front.png', kStillWidth)} alt="" loading="lazy" decoding="async" />
        ) : (
          <Icon name={cell.state === 'failed' ? 'alert' : 'shirt'} />
        )}
        {active && (
          <span class="hairbar">
            <i style={{ width: `${100 * cell.fraction}%` }} />
          </span>
        )}
      </span>
      <b class={`sweep-word is-${verdict}`}>{word}</b>
      {cell.figures ? <Figures figures={cell.figures} /> : <small>{cell.reason || (active ? percent(cell.fraction, 0) : '')}</small>}
    </>
  );
  if (!cell.job) return <span class="sweep-cell gone">{shown}</span>;
  return (
    <a class="sweep-cell" href={`#/jobs/${cell.job}`} aria-label={`${title}: ${word}`}>
      {shown}
    </a>
  );
}

function Figures({ figures }: { figures: SweepFigures }) {
  const { unit } = useAppState().dressing;
  return (
    <small class="sweep-figures">
      {easesOf(figures, unit.value).map(({ title, ease, tight }) => (
        <span key={title} class={tight ? 'tight' : ''}>
          {title} <em>{ease}</em>
        </span>
      ))}
      <span>
        {t.sweep.stretch} <em>{stretchOf(figures)}</em>
      </span>
      <span>
        {t.sweep.cpu} <em>{duration(figures.cpu_s)}</em>
      </span>
    </small>
  );
}
