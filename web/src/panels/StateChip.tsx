import type { JobState } from '../api/types';
import { stateName } from '../state/jobs';

/** A job's state as a word with its colour. */
export function StateChip({ state }: { state: JobState }) {
  return (
    <span class={`chip state-${state}`}>
      <i aria-hidden="true" />
      {stateName(state)}
    </span>
  );
}
