// Stills of the drape shown from where the 3D view is seen, taken by the service as its other stills are.

import { useSignal, type Signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Job, StillOrder, StillWish } from '../api/types';
import type { Viewpoint } from '../state/AppState';
import { useAppState } from '../state/context';
import { kServiceMaps, type MapKind } from '../state/clothMaps';
import { isActive } from '../state/jobs';
import { inSentence } from '../state/words';
import { Icon } from '../controls/Icon';
import { t } from '../texts/language';
import { told } from '../texts/told';

export interface PictureTaking {
  takeStill(job: string, wish: StillWish): Promise<StillOrder>;
  takenStills(job: string): Promise<StillOrder[]>;
  resultUrl(job: string, name: string, width?: number): string;
}

/** Of the longer side, pixels; the stills that every drape has are as large. */
const kSide = 1280;
/** Between two looks at one that is being taken, ms. */
const kLookEvery = 500;
const kSmall = 240;
/** What stills are taken of. */
const kFilm = 'drape.film';

const isUnderWay = (order: StillOrder): boolean => order.state === 'queued' || order.state === 'making';

function wishFrom({ eye, target, angle, aspect }: Viewpoint, transparent: boolean, map: MapKind | null): StillWish {
  const width = Math.round(Math.min(kSide, kSide * aspect));
  const height = Math.round(Math.min(kSide, kSide / aspect));
  return { eye, target, angle, width, height, transparent, ...(map && { map: kServiceMaps[map] }) };
}

/** Nothing until the drape has ended, or where nobody takes pictures. */
export function Pictures({ job, taking }: { job: Job; taking?: PictureTaking | undefined }) {
  if (!taking || isActive(job.state) || !(kFilm in (job.results ?? {}))) return null;
  return (
    <>
      <h3>{t.report.pictures.title}</h3>
      <Taken key={job.id} job={job} taking={taking} />
    </>
  );
}

async function answered(answer: Promise<StillOrder[]>, orders: Signal<StillOrder[]>, trouble: Signal<string>): Promise<void> {
  try {
    orders.value = await answer;
    trouble.value = '';
  } catch (error) {
    trouble.value = error instanceof Error ? error.message : String(error);
  }
}

function Taken({ job, taking }: { job: Job; taking: PictureTaking }) {
  const { lookingFrom, mapKind } = useAppState();
  const orders = useSignal<StillOrder[]>([]);
  const trouble = useSignal('');
  const clear = useSignal(false);
  const plain = useSignal(false);
  const under = orders.value.some(isUnderWay);

  const take = async (from: Viewpoint): Promise<StillOrder[]> => {
    const order = await taking.takeStill(job.id, wishFrom(from, clear.value, plain.value ? null : mapKind.value));
    return [...orders.value.filter((other) => other.name !== order.name), order];
  };
  useEffect(() => void answered(taking.takenStills(job.id), orders, trouble), [job.id, taking, orders, trouble]);
  useEffect(() => {
    if (!under) return;
    const timer = setInterval(() => void answered(taking.takenStills(job.id), orders, trouble), kLookEvery);
    return () => clearInterval(timer);
  }, [under, job.id, taking, orders, trouble]);

  const failed = orders.value.find((order) => order.error);
  const words = trouble.value || (failed?.error ? told(failed.error.code, failed.error.detail).text : '');
  const from = lookingFrom.value;
  return (
    <>
      <ul class="downloads">
        <li>
          <button class="movie" disabled={under || !from} onClick={() => from && void answered(take(from()), orders, trouble)}>
            <Icon name="camera" />
            <span>
              <b>{t.report.pictures.take}</b>
              <small role="status">{under ? t.report.pictures.takes : words || t.report.pictures.asked}</small>
            </span>
          </button>
        </li>
        <li>
          <Check on={clear.value} flip={() => (clear.value = !clear.value)} label={t.report.pictures.clear} />
        </li>
        {mapKind.value && (
          <li>
            <Check
              on={!plain.value}
              flip={() => (plain.value = !plain.value)}
              label={t.report.pictures.map(inSentence(t.scene.maps[mapKind.value].title))}
            />
          </li>
        )}
      </ul>
      <TakenList names={orders.value.filter(({ state }) => state === 'made').map(({ name }) => name)} job={job} taking={taking} />
    </>
  );
}

function Check({ on, flip, label }: { on: boolean; flip: () => void; label: string }) {
  return (
    <label class="check">
      <input type="checkbox" checked={on} onChange={flip} />
      {label}
    </label>
  );
}

function TakenList({ names, job, taking }: { names: string[]; job: Job; taking: PictureTaking }) {
  if (names.length === 0) return null;
  return (
    <ul class="stills">
      {names.map((name, k) => (
        <li key={name}>
          <a href={taking.resultUrl(job.id, name)} download={`${job.name} ${name}`}>
            <img src={taking.resultUrl(job.id, name, kSmall)} alt="" decoding="async" />
            <span>{t.report.pictures.taken(k + 1)}</span>
          </a>
        </li>
      ))}
    </ul>
  );
}
