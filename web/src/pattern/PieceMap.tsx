// A map of the draped cloth on its flat piece, with the value under the pointer.

import type { Point } from '../api/types';
import { useAppState } from '../state/context';
import { bandPaths, kBands, valueAt } from '../state/clothMaps';
import { minus } from '../state/outline';
import type { PlacedPiece } from '../state/layout';

export interface PieceMapProps {
  placed: PlacedPiece;
  worldOf(event: MouseEvent): Point;
}

export function PieceMap({ placed, worldOf }: PieceMapProps) {
  const state = useAppState();
  const map = state.clothMap.value;
  const { topology } = state.cloth;
  if (!map || !topology) return null;
  const { piece, offset } = placed;
  const point = (event: PointerEvent): void => {
    state.pointedValue.value = valueAt(map, topology, piece.id, minus(worldOf(event), offset));
  };
  return (
    <g class="piece-map" onPointerMove={point} onPointerLeave={() => (state.pointedValue.value = NaN)}>
      {bandPaths(map, topology, piece.id).map(
        (path, band) => path && <path key={band} d={path} fill={kBands[band]} stroke={kBands[band]} />,
      )}
    </g>
  );
}
