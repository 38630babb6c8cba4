// A seam by its colour, its number and the pieces that it joins; a click lights it in both views.

import { useCommands } from '../commands/context';
import { loading, valueOf } from '../state/AppState';
import { useAppState } from '../state/context';
import { seamColour, seamTitle } from '../state/seamView';

export function SeamChip({ seam }: { seam: string }) {
  const { pieces, editing } = useAppState();
  const { pattern } = useCommands();
  const seams = valueOf(pieces.value ?? loading)?.seams ?? [];
  const on = editing.seam.value === seam;
  return (
    <button
      class="seam-chip"
      aria-pressed={on}
      onPointerEnter={() => pattern.lightSeam(seam)}
      onPointerLeave={() => pattern.lightSeam(null)}
      onClick={() => pattern.pointAtSeam(on ? null : seam)}
    >
      <i style={{ background: seamColour(seams.findIndex((one) => one.id === seam)) }} />
      {seamTitle(seams, seam)}
    </button>
  );
}
