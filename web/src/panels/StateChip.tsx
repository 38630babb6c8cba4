import type { JobState } from '../api/types';
import { stateNames } from '../state/jobs';

/** A job's state as a word with its colour. */
export function StateChip({ state }: { state: JobState }) {
  return (
    <span class={`chip state-${state}`}>
      <i aria-hidden="true" />
      {stateNames[state]}
    </span>
  );
}
