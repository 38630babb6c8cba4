// Beside the pattern: what is selected, in figures that can be typed; the seams; seams to accept.

import type { PatternUrls } from '../api/patternFiles';
import { valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { toolOf } from '../tools/table';
import { HistoryList } from './HistoryList';
import { PatternFiles } from './PatternFiles';
import { ProposalList } from './ProposalList';
import { SeamList } from './SeamList';
import { SelectionPanel } from './SelectionPanel';
import { VersionList } from './VersionList';
import { t } from '../texts/language';

export function PatternPanel({ files }: { files?: PatternUrls | undefined }) {
  const state = useAppState();
  const pieces = valueOf(state.pieces.value ?? { state: 'loading' });
  const { Panel } = toolOf(state.editing.tool.value);
  if (!pieces) return <p class="hint">{t.pattern.editedHere}</p>;
  return (
    <>
      {Panel && <Panel pieces={pieces} />}
      <SelectionPanel pieces={pieces} />
      <SeamList pieces={pieces} />
      <ProposalList pieces={pieces} />
      {files && <PatternFiles urls={files} />}
      <VersionList />
      <HistoryList />
    </>
  );
}
