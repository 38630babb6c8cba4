// The page's colours in the 3D view.

import type { SceneView } from './SceneView';

export const token = (name: string): string =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** In the light or dark that the browser asks for, until stopped. */
export function paintByTheme(scene: SceneView): () => void {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const paint = (): void =>
    scene.paint({
      air: [token('--air-top'), token('--air-bottom')],
      grid: token('--grid-3d'),
      shadow: Number(token('--shadow-3d')) || 0.3,
      dark: dark.matches,
    });
  paint();
  dark.addEventListener('change', paint);
  return () => dark.removeEventListener('change', paint);
}
