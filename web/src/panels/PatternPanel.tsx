// Beside the pattern: what is selected, in figures that can be typed; the seams; seams to accept.

import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { HistoryList } from './HistoryList';
import { ProposalList } from './ProposalList';
import { SeamDraftPanel } from './SeamDraftPanel';
import { SeamList } from './SeamList';
import { SelectionPanel } from './SelectionPanel';

export function PatternPanel() {
  const state = useAppState();
  const pieces = valueOf(state.pieces.value ?? { state: 'loading' });
  if (!pieces) return <p class="hint">The pattern of the project is edited here.</p>;
  return (
    <>
      {state.editing.tool.value === 'sew' && <SeamDraftPanel pieces={pieces} />}
      <SelectionPanel pieces={pieces} />
      <SeamList pieces={pieces} />
      <ProposalList pieces={pieces} />
      <HistoryList />
    </>
  );
}
