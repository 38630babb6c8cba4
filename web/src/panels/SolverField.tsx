// By which method the garment is draped: one of the project's settings.

import { useCommands } from '../commands/context';
import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { t } from '../texts/language';

const kSolvers = [
  { solver: 'toile', title: 'Toile' },
  { solver: 'paper', title: 'Kim and Park 2003' },
] as const;

export function SolverField() {
  const { edits } = useCommands();
  const pieces = valueOf(useAppState().pieces.value ?? { state: 'loading' });
  if (!pieces) return null;
  const now = kSolvers.find(({ solver }) => solver === pieces.solver) ?? kSolvers[0];
  const choose = (solver: string): void => {
    const chosen = kSolvers.find((one) => one.solver === solver);
    if (chosen) void edits.send({ edit: 'set_solver', solver: chosen.solver });
  };
  return (
    <section class="fabric" aria-label={t.drape.solver.how}>
      <h3>{t.drape.solver.how}</h3>
      <label class="select-field">
        <span>{t.drape.solver.solver}</span>
        <select value={now.solver} onChange={(event) => choose(event.currentTarget.value)}>
          {kSolvers.map(({ solver, title }) => (
            <option key={solver} value={solver}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <p class="selection-facts">{t.drape.solver[now.solver]} {t.drape.solver.next}</p>
    </section>
  );
}
