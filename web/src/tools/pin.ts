// Pins a point of the cloth where it is, while it drapes.

import type { SceneTool } from './SceneTool';

export const pin: SceneTool = {
  id: 'pin',
  isHeld: (state) => state.touchable.value && state.hands.tool.value === 'pin',
  cursor: 'crosshair',
  click: ({ commands }, touch) => {
    const point = touch.cloth();
    if (point) commands.live.pin(point);
    return point !== null;
  },
};
