// What was done to the project, newest first; what was undone is still there to be done again.

import { useAppState } from '../state/context';
import { stepText } from '../state/steps';
import { ago } from '../state/words';
import { t } from '../texts/language';

const kShown = 30;

export function HistoryList() {
  const state = useAppState();
  const steps = state.editing.history.value;
  if (steps.length === 0) return null;
  return (
    <details class="history">
      <summary>{t.pattern.history}</summary>
      <ol>
        {steps.slice(0, kShown).map((step) => (
          <li key={step.number} class={step.undone ? 'undone' : ''}>
            <span>{stepText(step.edits, state.known.value)}</span>
            <small>{step.undone ? t.pattern.undone : ago(step.created_ms, state.now.value)}</small>
          </li>
        ))}
      </ol>
    </details>
  );
}
