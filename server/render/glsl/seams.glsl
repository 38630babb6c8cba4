// Seams as they are pressed: both layers dip into the line where they meet and swell over their allowances;
// an edge that is free is turned in and sewn down. Heights are of the right side, m. Everything is averaged
// over a pixel, so that from afar a fine darker line is left, and from farther nothing.
// The stills and the page draw by this one file; what is here must hold in GLSL 3.30 and in GLSL ES 3.00.
in vec4 v_line_distance;              // m from the nearest border, four of them
in vec4 v_line_along;                 // m along it
in vec4 v_line_kind;                  // 0: a seam, -1: one that did not close, 2: a hem
in vec3 v_make;                       // m: thickness, width of a hem, from a seam to stitches beside it

const float kAllowance = 0.009;       // m
const float kStitch = 0.0028;         // m from one stitch to the next
const float kThread = 0.00022;        // m, half its width
const float kReach = 0.032;           // m, no line is drawn farther off

struct SeamLook {
  vec3 slope;                         // of the surface, to be taken from its normal
  float shade;                        // 1: none
  float thread;                       // 0 to 1
};

vec3 thread_of(vec3 cloth) {
  float bright = dot(cloth, vec3(0.2126, 0.7152, 0.0722));
  return bright < 0.06 ? cloth * 1.5 + 0.03 : cloth * 0.62;
}

float seam_height(float d, float thick) {
  float dip = 1.0 - exp(-d * d / (2.6 * thick * thick));
  return thick * dip * (1.0 - 0.55 * smoothstep(kAllowance - 0.002, kAllowance + 0.002, d));
}

float hem_height(float d, float thick, float hem) {
  float rounded = 1.0 - exp(-d / thick);
  return thick * (1.2 * rounded - 0.7 * smoothstep(hem - 0.001, hem + 0.0015, d));
}

// How much of a pixel lies on a soft line of this half width, d off its middle.
float line_share(float d, float half_width, float a_pixel) {
  float wide = sqrt(half_width * half_width + 0.25 * a_pixel * a_pixel);
  return exp(-d * d / (wide * wide)) * half_width / wide;
}

float stitches(float d, float along, float at, float a_pixel, float along_pixel) {
  float beat = abs(fract(along / kStitch) - 0.5) * 2.0;
  float dash = mix(1.0 - smoothstep(0.62, 0.82, beat), 0.72, smoothstep(0.35, 0.9, along_pixel / kStitch));
  return dash * line_share(d - at, kThread, a_pixel);
}

void add_line(int i, float thick, vec3 towards, float a_pixel, float along_pixel, inout SeamLook look) {
  float d = v_line_distance[i], along = v_line_along[i], half_pixel = 0.5 * a_pixel;
  float near = max(abs(d - half_pixel), 0.0), far = d + half_pixel;
  if (v_line_kind[i] > 1.5) {
    float hem = max(v_make.y, 2.0 * thick);
    look.slope += towards * ((hem_height(far, thick, hem) - hem_height(near, thick, hem)) / a_pixel);
    look.thread = max(look.thread, stitches(d, along, hem - 0.0015, a_pixel, along_pixel));
    look.shade *= 1.0 - 0.25 * line_share(d - hem, 0.0012, a_pixel);
    return;
  }
  look.slope += towards * ((seam_height(far, thick) - seam_height(near, thick)) / a_pixel);
  look.shade *= 1.0 - 0.50 * line_share(d, max(0.9 * thick, 0.0004), a_pixel);
  if (v_make.z > 0.0) look.thread = max(look.thread, stitches(d, along, v_make.z, a_pixel, along_pixel));
}

SeamLook seams(vec3 n, vec3 p) {
  SeamLook look = SeamLook(vec3(0.0), 1.0, 0.0);
  vec3 across = dFdx(p), down = dFdy(p);
  vec3 r1 = cross(down, n), r2 = cross(n, across);
  float det = dot(across, r1);
  vec4 dx = dFdx(v_line_distance), dy = dFdy(v_line_distance);
  vec4 along_pixels = abs(dFdx(v_line_along)) + abs(dFdy(v_line_along));
  float thick = clamp(v_make.x, 0.00015, 0.0012);
  for (int i = 0; i < 4; ++i) {
    if (v_line_distance[i] > kReach) continue;
    // After M. S. Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU" (2010): the gradient of the distance.
    vec3 towards = (dx[i] * r1 + dy[i] * r2) / (abs(det) > 1e-14 ? det : 1e-14);
    towards /= max(length(towards), 1.0);
    float a_pixel = max(length(vec2(dx[i], dy[i])), 1e-6);
    add_line(i, thick, towards, a_pixel, along_pixels[i], look);
  }
  return look;
}
