// Movies of the drape shown: asked for with a button, made by the service, then a file to take along.

import { useSignal, type Signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Job, MovieKind, MovieOrder } from '../api/types';
import { isActive } from '../state/jobs';
import { percent } from '../state/words';
import { Icon } from '../controls/Icon';
import { t } from '../texts/language';
import { told } from '../texts/told';

export interface MovieMaking {
  makeMovie(job: string, kind: MovieKind): Promise<MovieOrder>;
  movies(job: string): Promise<MovieOrder[]>;
  resultUrl(job: string, name: string): string;
}

const kKinds: readonly MovieKind[] = ['drape', 'turntable'];

/** Between two looks at a movie that is being made, ms. */
const kLookEvery = 1000;

/** What movies are made of. */
const kFilm = 'drape.film';

/** Nothing until the drape has ended, or where nobody makes movies. */
export function Movies({ job, making }: { job: Job; making?: MovieMaking | undefined }) {
  if (!making || isActive(job.state) || !(kFilm in (job.results ?? {}))) return null;
  return (
    <>
      <h3>{t.report.movies.title}</h3>
      <ul class="downloads">
        {kKinds.map((kind) => (
          <MovieRow key={job.id + kind} job={job.id} kind={kind} title={t.report.movies[kind]} of={job.name} making={making} />
        ))}
      </ul>
    </>
  );
}

interface RowProps {
  job: string;
  kind: MovieKind;
  title: string;
  of: string;
  making: MovieMaking;
}

const isUnderWay = (order: MovieOrder | null): boolean => order?.state === 'queued' || order?.state === 'making';

function wordsOf(order: MovieOrder | null, trouble: string): string {
  if (trouble) return trouble;
  if (!order) return t.report.movies.asked;
  if (order.state === 'queued') return t.report.movies.waits;
  if (order.state === 'making') return t.report.movies.made(percent(order.fraction, 0));
  return order.error ? told(order.error.code, order.error.detail).text : 'MP4';
}

async function tell(
  answer: Promise<MovieOrder | undefined>,
  order: Signal<MovieOrder | null>,
  trouble: Signal<string>,
): Promise<void> {
  try {
    order.value = (await answer) ?? null;
    trouble.value = '';
  } catch (error) {
    order.value = null;
    trouble.value = error instanceof Error ? error.message : String(error);
  }
}

function MovieRow({ job, kind, title, of, making }: RowProps) {
  const order = useSignal<MovieOrder | null>(null);
  const trouble = useSignal('');
  const under = isUnderWay(order.value);
  const file = order.value?.name;
  useEffect(() => {
    if (!under || !file) return;
    const look = async (): Promise<MovieOrder | undefined> =>
      (await making.movies(job)).find((movie) => movie.name === file);
    const timer = setInterval(() => void tell(look(), order, trouble), kLookEvery);
    return () => clearInterval(timer);
  }, [under, file, job, making, order, trouble]);
  const words = <small role="status">{wordsOf(order.value, trouble.value)}</small>;
  if (file && order.value?.state === 'made') {
    return (
      <li>
        <a href={making.resultUrl(job, file)} download={`${of} ${file}`}>
          <Icon name="down" />
          <span>
            <b>{title}</b>
            {words}
          </span>
        </a>
      </li>
    );
  }
  return (
    <li>
      <button class="movie" disabled={under} onClick={() => void tell(making.makeMovie(job, kind), order, trouble)}>
        <Icon name="play" />
        <span>
          <b>{title}</b>
          {words}
        </span>
      </button>
    </li>
  );
}
