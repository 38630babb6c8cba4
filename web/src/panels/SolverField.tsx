// By which method the garment is draped: one of the project's settings.

import { useCommands } from '../commands/context';
import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';

const kSolvers = [
  { solver: 'toile', title: 'Toile', words: 'Nothing goes through anything.' },
  {
    solver: 'paper',
    title: 'Kim and Park 2003',
    words: 'The method of the paper, to compare with. It may let cloth through; crossings are counted.',
  },
] as const;

export function SolverField() {
  const { pattern } = useCommands();
  const pieces = valueOf(useAppState().pieces.value ?? { state: 'loading' });
  if (!pieces) return null;
  const now = kSolvers.find(({ solver }) => solver === pieces.solver) ?? kSolvers[0];
  const choose = (solver: string): void => {
    const chosen = kSolvers.find((one) => one.solver === solver);
    if (chosen) void pattern.edit({ edit: 'set_solver', solver: chosen.solver });
  };
  return (
    <section class="fabric" aria-label="How it is draped">
      <h3>How it is draped</h3>
      <label class="select-field">
        <span>Solver</span>
        <select value={now.solver} onChange={(event) => choose(event.currentTarget.value)}>
          {kSolvers.map(({ solver, title }) => (
            <option key={solver} value={solver}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <p class="selection-facts">{now.words} It counts from the next drape on.</p>
    </section>
  );
}
