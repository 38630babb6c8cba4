// A seam by its colour, its number and the pieces that it joins; a click lights it in both views.

import { useCommands } from '../commands/context';
import { useAppState } from '../state/context';
import { seamTitle } from '../state/seamNames';
import { seamColour } from '../state/seamView';

export function SeamChip({ seam }: { seam: string }) {
  const { editing, sewn } = useAppState();
  const { pattern } = useCommands();
  const on = editing.seam.value === seam;
  return (
    <button
      class="seam-chip"
      aria-pressed={on}
      onPointerEnter={() => pattern.lightSeam(seam)}
      onPointerLeave={() => pattern.lightSeam(null)}
      onClick={() => pattern.pointAtSeam(on ? null : seam)}
    >
      <i style={{ background: seamColour(sewn.value.seams.findIndex((one) => one.id === seam)) }} />
      {seamTitle(sewn.value, seam)}
    </button>
  );
}
