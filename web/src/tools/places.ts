// Drags pieces onto the sides of the boxes around the body, while they are arranged.

import type { Aim, SceneTool } from './SceneTool';

const kNowhere: Aim = { cursor: 'not-allowed', drop: () => undefined };

export const places: SceneTool = {
  id: 'places',
  isHeld: (state) => state.beforeDrape.value && state.tab.value === 'arrange',
  press: ({ commands }, touch) => {
    const piece = touch.piece();
    if (piece === null) return null;
    return {
      clicks: true,
      begin: (under) => under.openBoxes(true),
      to: (under) => {
        const at = under.box();
        commands.hover(piece);
        return at ? { cursor: 'copy', drop: () => void commands.dressing.drop(piece, at) } : kNowhere;
      },
      end: (under) => under.openBoxes(false),
    };
  },
};
