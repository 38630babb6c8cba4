// Proposals of seams, surest first, with ticks: those that are sure are ticked.

import { useSignal } from '@preact/signals';
import { useCommands } from '../commands/context';
import type { Import } from '../api/types';
import { piecesDrawn, seamsInReach, sourceNames, type ImportDraft } from '../state/importDraft';
import { kSure, seamColour, unsewn } from '../state/seamView';
import { percent } from '../state/words';
import { ProposalRow, ProposalRows } from './ProposalList';
import { UnsewnPieces } from './UnsewnPieces';
import { t } from '../texts/language';

export interface ImportSeamsProps {
  draft: ImportDraft;
  report: Import;
  onLight(seam: string | null): void;
  /** By its name in the file. */
  onPiece(piece: string | null): void;
}

export function ImportSeams({ draft, report, onLight, onPiece }: ImportSeamsProps) {
  const { imports } = useCommands();
  const seams = seamsInReach(report, draft.left);
  const pieces = piecesDrawn(report);
  const sources = sourceNames(report);
  const only = useSignal<string | null>(null);
  const staying = pieces.filter(({ id }) => sources.has(id) && !draft.left.has(sources.get(id)!));
  const of = staying.some(({ id }) => id === only.value) ? only.value : null;
  const loose = unsewn(staying, seams.filter((seam) => draft.chosen.has(seam.id)));
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
      <UnsewnPieces pieces={loose} chosen={of} choose={(piece) => (only.value = piece)} light={(piece) => onPiece(piece && (sources.get(piece) ?? piece))} />
      <ProposalRows
        proposals={seams}
        of={of}
        all={() => (only.value = null)}
        row={(seam) => (
          <ProposalRow
            key={seam.id}
            proposal={seam}
            pieces={pieces}
            on={draft.chosen.has(seam.id)}
            colour={seamColour(report.seams.indexOf(seam))}
            turn={(on) => imports.takeSeam(seam.id, on)}
            light={(on) => onLight(on ? seam.id : null)}
          />
        )}
      />
    </section>
  );
}
