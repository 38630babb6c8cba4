// Proposals of seams, surest first, with ticks: those that are sure are ticked.

import { useCommands } from '../commands/context';
import type { Import } from '../api/types';
import { piecesDrawn, seamsInReach, type ImportDraft } from '../state/importDraft';
import { kSure, seamColour } from '../state/seamView';
import { percent } from '../state/words';
import { ProposalRow } from './ProposalList';
import { t } from '../texts/language';

export interface ImportSeamsProps {
  draft: ImportDraft;
  report: Import;
  onLight(seam: string | null): void;
}

export function ImportSeams({ draft, report, onLight }: ImportSeamsProps) {
  const { imports } = useCommands();
  const seams = seamsInReach(report, draft.left);
  const pieces = piecesDrawn(report);
  if (seams.length === 0) {
    return (
      <p class="hint">
        {t.imports.noSeams} <kbd>N</kbd>.
      </p>
    );
  }
  return (
    <section class="proposals" aria-label={t.imports.proposed}>
      {draft.source.kind === 'dxf' ? (
        <p class="hint">
          {t.imports.dxfSeams(percent(kSure, 0))}
        </p>
      ) : (
        <p class="hint">{t.imports.specified}</p>
      )}
      <div class="button-row">
        <button class="plain" onClick={() => imports.takeSurest(kSure)}>
          {t.imports.sureOnes}
        </button>
        <button class="plain" onClick={() => imports.takeSurest(0)}>
          {t.common.all}
        </button>
        <button class="plain" onClick={() => imports.takeSurest(2)}>
          {t.common.none}
        </button>
      </div>
      <ul>
        {seams.map((seam) => (
          <ProposalRow
            key={seam.id}
            proposal={seam}
            pieces={pieces}
            on={draft.chosen.has(seam.id)}
            colour={seamColour(report.seams.indexOf(seam))}
            turn={(on) => imports.takeSeam(seam.id, on)}
            light={(on) => onLight(on ? seam.id : null)}
          />
        ))}
      </ul>
    </section>
  );
}
