// Takes hold of the cloth while it drapes, and draws it along with the pointer.

import type { SceneTool } from './SceneTool';

export const pull: SceneTool = {
  id: 'pull',
  isHeld: (state) => state.touchable.value && state.hands.tool.value === 'pull',
  cursor: 'grab',
  press: ({ commands }, touch) => {
    const point = touch.cloth();
    if (!point) return null; // beside the cloth the view turns
    commands.live.hold(point);
    return {
      cursor: 'grabbing',
      clicks: false,
      to: (under) => {
        commands.live.draw(under.beside(point.at));
        return null;
      },
      end: () => commands.live.letGo(),
    };
  },
};
