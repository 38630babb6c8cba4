// The card of the tour, beside the place that it tells of. It takes no focus and keeps nobody from working.

import { useSignal } from '@preact/signals';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { besides, tourStops, type Rect, type TourStop } from '../state/tour';
import { t } from '../texts/language';

export function Tour() {
  const { tourStop, atWork } = useAppState();
  const stop = tourStop.value === null ? undefined : tourStops[tourStop.value];
  return stop && atWork.value ? <Stop stop={stop} number={tourStop.value!} /> : null;
}

interface Standing {
  place: Rect;
  card: { left: number; top: number };
}

function Stop({ stop, number }: { stop: TourStop; number: number }) {
  const { tours } = useCommands();
  const card = useRef<HTMLElement>(null);
  const standing = useStanding(stop, card);
  const last = number === tourStops.length - 1;
  const words = t.tour.stops[stop.id];
  return (
    <>
      {standing && <div class="tour-ring" style={pixels(standing.place)} aria-hidden="true" />}
      <section class="tour" ref={card} style={standing ? pixels(standing.card) : {}} aria-label={t.tour.title}>
        <div aria-live="polite">
          <small>{t.tour.count(number + 1, tourStops.length)}</small>
          <h2>{words.title}</h2>
          <p>{words.text}</p>
        </div>
        <div class="button-row">
          {!last && (
            <button class="plain" onClick={() => tours.end()}>
              {t.tour.skip}
            </button>
          )}
          {number > 0 && (
            <button class="plain" onClick={() => tours.step(-1)}>
              {t.tour.back}
            </button>
          )}
          <button class="primary" onClick={() => tours.step(1)}>
            {last ? t.tour.done : t.tour.next}
          </button>
        </div>
      </section>
    </>
  );
}

const pixels = (box: Partial<Rect>): Record<string, string> =>
  Object.fromEntries(Object.entries(box).map(([name, value]) => [name, `${value}px`]));

/** Where the place of a stop is, and its card; found anew whenever either changes its size or the page is scrolled. */
function useStanding(stop: TourStop, card: { current: HTMLElement | null }): Standing | null {
  const standing = useSignal<Standing | null>(null);
  useLayoutEffect(() => {
    const found = stop.places.flatMap((place) => [...document.querySelectorAll(place)]);
    const place = found.find((one) => one.getClientRects().length > 0);
    const own = card.current;
    if (!place || !own) return void (standing.value = null);
    place.scrollIntoView({ block: 'nearest' });
    const find = (): void => {
      const { left, top, width, height } = place.getBoundingClientRect();
      const size = { width: own.offsetWidth, height: own.offsetHeight };
      const at = { left, top, width, height };
      standing.value = { place: at, card: besides(at, size, { width: innerWidth, height: innerHeight }) };
    };
    find();
    const watch = new ResizeObserver(find);
    for (const one of [place, own, document.body]) watch.observe(one);
    window.addEventListener('scroll', find, true);
    return () => {
      watch.disconnect();
      window.removeEventListener('scroll', find, true);
    };
  }, [stop, card, standing]);
  return standing.value;
}
