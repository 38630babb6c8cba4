// What draws the scene: WebGL, with the light and the shadows of the stills as far as a page can have them.

import { CustomToneMapping, PCFShadowMap, ShaderChunk, SRGBColorSpace, VSMShadowMap, WebGLRenderer } from 'three';

/** With it, cloth is as bright as on the stills. */
const kExposure = 1.18;

/** `slow`: drawn by the processor, which smooths by more pixels instead of samples when things rest. */
export function makeRenderer(canvas: HTMLCanvasElement, slow: boolean): WebGLRenderer {
  const renderer = new WebGLRenderer({
    canvas,
    antialias: !slow,
    alpha: true,
    powerPreference: 'high-performance',
  });
  renderer.toneMappingExposure = kExposure;
  renderer.outputColorSpace = SRGBColorSpace;
  developAsStills();
  renderer.toneMapping = CustomToneMapping;
  renderer.shadowMap.enabled = true;
  // The soft one costs the processor two thirds of its frames.
  renderer.shadowMap.type = slow ? PCFShadowMap : VSMShadowMap;
  return renderer;
}

/** Linear light to display as the stills do it (server/render/glsl/studio.glsl): colours stay what they are, with a soft
 *  shoulder. */
function developAsStills(): void {
  ShaderChunk.tonemapping_pars_fragment = ShaderChunk.tonemapping_pars_fragment.replace(
    'vec3 CustomToneMapping( vec3 color ) { return color; }',
    `vec3 CustomToneMapping( vec3 color ) {
      vec3 light = toneMappingExposure * color;
      return min(light, 0.7) + 0.3 * (1.0 - exp(-max(light - 0.7, 0.0) / 0.3));
    }`,
  );
}

/** Pixels of the picture to one of the page, at most. */
export const finestRatio = (): number => Math.min(window.devicePixelRatio, 2);

/** Whether WebGL is more than a stand-in drawn by the processor. */
export function hasGraphicsCard(): boolean {
  const probe = document.createElement('canvas').getContext('webgl2', { failIfMajorPerformanceCaveat: true });
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  return probe !== null;
}
