// Drags landmarks over the body, while they are shown.

import type { AppState } from '../state/AppState';
import type { SceneTool } from './SceneTool';

/** The body's landmarks can be touched. */
export const landmarksShown = (state: AppState): boolean =>
  state.beforeDrape.value && state.shownMarks.value.landmarks;

export const landmarks: SceneTool = {
  id: 'landmarks',
  isHeld: (state) => landmarksShown(state) && state.dressing.picking.value === null,
  press: ({ commands }, touch) => {
    const landmark = touch.landmark();
    if (landmark === null) return null;
    return {
      cursor: 'grabbing',
      clicks: false,
      to: (under) => {
        const at = under.skin();
        if (!at) return null; // beside the body it stays where it was seen last
        under.moveLandmark(landmark, at);
        return { drop: () => void commands.dressing.mark(landmark, at) };
      },
    };
  },
};
