// The way from a drape to another beside it.

import { useCommands } from '../commands/context';
import type { Job } from '../api/types';
import { comparable } from '../state/comparison';
import { useAppState } from '../state/context';
import { madeOf } from '../state/versions';
import { ago } from '../state/words';
import { t } from '../texts/language';

/** Null while there is no other to set it beside. */
export function CompareWith({ job }: { job: Job }) {
  const state = useAppState();
  const commands = useCommands();
  const others = comparable(state.allJobs.value, job);
  if (others.length === 0) return null;
  const nameOf = (other: Job): string =>
    `${other.project_id === job.project_id ? '' : `${other.name}, `}${madeOf(state.versions.list.value, other)} · ${ago(other.ended_ms || other.created_ms, state.now.value)}`;
  return (
    <label class="select-field">
      <span>{t.report.compareWith}</span>
      <select
        value=""
        onChange={(event) => {
          const other = event.currentTarget.value;
          if (other) commands.open({ name: 'compare', left: other, right: job.id });
        }}
      >
        <option value="">{t.report.anotherDrape}</option>
        {others.map((other) => (
          <option key={other.id} value={other.id}>
            {nameOf(other)}
          </option>
        ))}
      </select>
    </label>
  );
}
