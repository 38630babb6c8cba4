// Reads the map's value under the pointer.

import type { SceneTool } from './SceneTool';

export const probe: SceneTool = {
  id: 'probe',
  isHeld: (state) => state.clothMap.value !== null,
  hover: ({ state }, touch) => {
    state.pointedValue.value = touch?.mapValue() ?? NaN;
  },
};
