// A snippet of a fabric: its colour, with threads as its weave lays them, much enlarged.

import { useId } from 'preact/hooks';
import type { Fabric } from '../api/types';
import { weaveOf, type Weave } from '../state/fabrics';
import { cssColour } from '../state/patternGeometry';

/** One repeat: side in pixels, and the threads that lie over the others; the ground is what lies below. */
const kThreads: Record<Weave, { side: number; over: string }> = {
  plain: { side: 6, over: 'M0 1.5H3M3 4.5H6' },
  twill: { side: 8, over: 'M-1 3L3 -1M-1 7L7 -1M1 9L9 1M5 9L9 5' },
  satin: { side: 12, over: 'M0 1.2H10M4 4.2H12M0 4.2H2M0 7.2H6M8 7.2H12M0 10.2H10' },
  knit: { side: 7, over: 'M0 1L3.5 5L7 1M0 8L3.5 12L7 8M0 -6L3.5 -2L7 -6' },
  net: { side: 8, over: 'M0 2L4 0L8 2M0 2V6M8 2V6M0 6L4 8L8 6' },
  felt: { side: 9, over: 'M1 2L4 1M6 5L8 3M2 7L5 8M7 8L8 7' },
};

export function FabricSwatch({ fabric, size = 44 }: { fabric: Fabric; size?: number }) {
  const id = useId();
  const { side, over } = kThreads[weaveOf(fabric)];
  const [r, g, b] = fabric.colour;
  const light = 0.3 * r + 0.6 * g + 0.1 * b < 0.3;
  return (
    <svg class="swatch" width={size} height={size} aria-hidden="true">
      <defs>
        <pattern id={id} width={side} height={side} patternUnits="userSpaceOnUse">
          <path d={over} fill="none" stroke={light ? '#ffffff' : '#000000'} stroke-opacity={light ? 0.22 : 0.16} stroke-width={1.4} />
        </pattern>
      </defs>
      <rect width="100%" height="100%" fill={cssColour(fabric.colour)} />
      <rect width="100%" height="100%" fill={`url(#${id})`} />
    </svg>
  );
}
