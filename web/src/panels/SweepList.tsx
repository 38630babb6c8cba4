// The sweeps in the rail, beneath the projects; nothing where there are none.

import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { cellsOf, doneOf } from '../state/sweeps';
import { ago } from '../state/words';
import { t } from '../texts/language';
import { Icon } from '../controls/Icon';

export function SweepList() {
  const state = useAppState();
  const sweeps = valueOf(state.sweeps.list.value) ?? [];
  const route = state.route.value;
  if (sweeps.length === 0) return null;
  return (
    <>
      <div class="rail-head">
        <h2>{t.sweep.sweeps}</h2>
      </div>
      <ul class="rail-list">
        {sweeps.map((sweep) => (
          <li key={sweep.id}>
            <a
              class="row"
              href={`#/sweeps/${sweep.id}`}
              aria-current={route.name === 'sweep' && route.id === sweep.id ? 'page' : undefined}
            >
              <span class="thumb">
                <Icon name="grid" />
              </span>
              <span class="row-text">
                <b>{sweep.name}</b>
                <small>
                  {sweep.ended
                    ? `${t.sweep.drapes(cellsOf(sweep))} · ${ago(sweep.created_ms, state.now.value)}`
                    : t.sweep.under(doneOf(sweep), cellsOf(sweep))}
                </small>
              </span>
            </a>
          </li>
        ))}
      </ul>
    </>
  );
}
