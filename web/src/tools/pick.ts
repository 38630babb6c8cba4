// Puts the landmark that was named to where the body is clicked.

import { landmarksShown } from './landmarks';
import type { SceneTool } from './SceneTool';

export const pick: SceneTool = {
  id: 'pick',
  isHeld: (state) => landmarksShown(state) && state.dressing.picking.value !== null,
  cursor: 'crosshair',
  click: ({ state, commands }, touch) => {
    const landmark = state.dressing.picking.peek();
    const at = touch.skin();
    if (landmark === null || !at) return false;
    void commands.dressing.mark(landmark, at);
    return true;
  },
};
