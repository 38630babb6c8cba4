// The way into the tour, where there is something to be led around in.

import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { t } from '../texts/language';

/** `begun`: what it lies in is left. */
export function TourButton({ class: more = '', begun }: { class?: string; begun?: () => void }) {
  const { atWork } = useAppState();
  const { tours } = useCommands();
  if (!atWork.value) return null;
  const begin = (): void => {
    begun?.();
    tours.begin();
  };
  return (
    <button class={`plain ${more}`.trim()} onClick={begin}>
      {t.tour.again}
    </button>
  );
}
