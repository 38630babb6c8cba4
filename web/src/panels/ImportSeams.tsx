// Proposals of seams, surest first, with ticks: those that are sure are ticked.

import { useCommands } from '../commands/context';
import type { Import } from '../api/types';
import { piecesDrawn, seamsInReach, type ImportDraft } from '../state/importDraft';
import { kSure, seamColour } from '../state/seamView';
import { percent } from '../state/words';
import { ProposalRow } from './ProposalList';

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
        The file names no seams, and none could be found. They can be sewn by hand on the pattern, with <kbd>N</kbd>.
      </p>
    );
  }
  return (
    <section class="proposals" aria-label="Proposed seams">
      {draft.source.kind === 'dxf' ? (
        <p class="hint">
          A DXF says what is cut, not how it is sewn. These seams follow from lengths, notches, shapes and names; those
          of {percent(kSure, 0)} and above are ticked, and likely ones whose edges nothing surer wants, or whose pieces nothing surer holds on. Where two want the same edge, one takes the place of the other.
        </p>
      ) : (
        <p class="hint">The specification says how its pieces are stitched.</p>
      )}
      <div class="button-row">
        <button class="plain" onClick={() => imports.takeSurest(kSure)}>
          The sure ones
        </button>
        <button class="plain" onClick={() => imports.takeSurest(0)}>
          All
        </button>
        <button class="plain" onClick={() => imports.takeSurest(2)}>
          None
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
