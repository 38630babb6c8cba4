// Seams and hems in the shader of cloth: heights, widths and threads are those of the stills, by the same file.

import seams from '../../../server/render/glsl/seams.glsl?raw';

export const kSeamVertexHead = `
attribute vec4 lineDistance;
attribute vec4 lineAlong;
attribute vec4 lineKind;
attribute vec3 make;
varying vec4 v_line_distance;
varying vec4 v_line_along;
varying vec4 v_line_kind;
varying vec3 v_make;`;

export const kSeamVertex = `
v_line_distance = lineDistance;
v_line_along = lineAlong;
v_line_kind = lineKind;
v_make = make;`;

export const kSeamFragmentHead = `\n${seams}`;

/** After the normal is known: what moves is drawn with the shade alone, by whoever is slow. */
export const kSeamFragment = `
#ifdef USE_NORMALMAP
SeamLook seam = seams(normal * faceDirection, -vViewPosition);
normal = normalize(normal - seam.slope * faceDirection);
diffuseColor.rgb = mix(diffuseColor.rgb * seam.shade, thread_of(diffuseColor.rgb), seam.thread);
#else
vec4 seamAway = v_line_distance + 0.5 * step(1.5, v_line_kind);
float seamNear = min(min(seamAway.x, seamAway.y), min(seamAway.z, seamAway.w));
diffuseColor.rgb *= 1.0 - 0.5 * line_share(seamNear, 0.0005, max(fwidth(seamNear), 1e-6));
#endif`;
