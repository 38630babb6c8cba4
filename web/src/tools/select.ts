// Lights up the piece under the pointer, and selects it with a click.

import type { SceneTool } from './SceneTool';

export const select: SceneTool = {
  id: 'select',
  isHeld: () => true,
  click: ({ commands }, touch) => {
    commands.select(touch.piece());
    return true;
  },
  hover: ({ commands }, touch) => commands.hover(touch?.piece() ?? null),
};
