in vec3 v_position;
in vec3 v_normal;
in vec2 v_sky;
in vec3 v_bend_square, v_bend_cross, v_bend_from;
uniform vec3 eye;
uniform vec3 fill_light, rim_light;   // towards the lights
out vec4 pixel;

#if CLOTH
in vec3 v_colour;
in vec2 v_rest;
in vec2 v_picture_at;
uniform bool pictured;                // the panel shows a picture
uniform sampler2D picture;

float value_noise(vec2 at) {
  vec2 cell = floor(at), f = at - cell;
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(noise_at(cell), noise_at(cell + vec2(1, 0)), f.x),
             mix(noise_at(cell + vec2(0, 1)), noise_at(cell + vec2(1, 1)), f.x), f.y);
}

uniform vec4 look;                    // roughness, sheen, unevenness, m of the weave's tile
uniform sampler2D weave;              // slopes along and across the grain, tone

// Uneven yarn along warp and weft; it fades before it could shimmer.
float yarn_tone() {
  float footprint = max(length(dFdx(v_rest)), length(dFdy(v_rest)));
  if (footprint > 0.004 || look.z < 0.015) return 1.0;
  float broad = value_noise(v_rest * vec2(260.0, 30.0)) + value_noise(v_rest.yx * vec2(260.0, 30.0) + 57.0) - 1.0;
  return 1.0 + look.z * broad * smoothstep(0.004, 0.0015, footprint);
}

// xyz: slope of the threads, to be taken from the normal; w: tone.
vec4 threads(vec3 n, vec3 p) {
  vec4 tile = texture(weave, v_rest / look.w);
  vec2 slope = (tile.xy * 255.0 - 128.0) / 127.0;
  vec3 across = dFdx(p), down = dFdy(p);
  vec3 r1 = cross(down, n), r2 = cross(n, across);
  float det = dot(across, r1);
  if (abs(det) < 1e-14) return vec4(0.0, 0.0, 0.0, 1.0);
  vec2 dx = dFdx(v_rest), dy = dFdy(v_rest);
  return vec4((slope.x * (dx.x * r1 + dy.x * r2) + slope.y * (dx.y * r1 + dy.y * r2)) / det, tile.z / 0.8);
}

// Light that a rough surface throws back about the mirror's direction: GGX with Smith's shadowing as in B. Karis,
// "Real Shading in Unreal Engine 4" (2013), and Schlick's Fresnel from 0.04.
float gloss(vec3 n, vec3 to_light, vec3 to_eye, float roughness) {
  vec3 h = normalize(to_light + to_eye);
  float nl = max(dot(n, to_light), 0.0), nv = max(dot(n, to_eye), 0.02), nh = max(dot(n, h), 0.0);
  float a = roughness * roughness, b = nh * nh * (a * a - 1.0) + 1.0, k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
  float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(h, to_eye), 0.0), 5.0);
  return nl * a * a / (b * b) * fresnel / (4.0 * (nl * (1.0 - k) + k) * (nv * (1.0 - k) + k));
}
#else
uniform vec3 body_colour;
#endif

// How far the round surface lies from its facet: the mean of the pixel's places on the planes of the triangle's
// corners (T. Boubekeur, M. Alexa, "Phong Tessellation", 2008). The sum over corners of n (n . p) is linear in what
// the corners hand on, n n^T and n (n . corner). Shadows are looked for from there and along the smooth surface: a facet's
// own depth would put what its smooth shade calls lit into the shadow of its neighbours.
const float kFarthestBend = 0.012;   // m: more is no roundness but a corner with one normal, a table's for instance
vec3 bend(vec3 p) {
  vec3 s = v_bend_square, c = v_bend_cross;   // c: xy, yz, zx
  vec3 onto = vec3(s.x * p.x + c.x * p.y + c.z * p.z, c.x * p.x + s.y * p.y + c.y * p.z, c.z * p.x + c.y * p.y + s.z * p.z);
  vec3 away = v_bend_from - onto;
  return away * min(1.0, kFarthestBend / max(length(away), 1e-9));
}

void main() {
  vec3 to_eye = normalize(eye - v_position);
  float side = gl_FrontFacing ? 1.0 : -1.0;
  vec3 smooth_normal = normalize(v_normal) * side;
  vec3 n = smooth_normal;
  float sky = gl_FrontFacing ? v_sky.x : v_sky.y;
  float through = gl_FrontFacing ? v_sky.y : v_sky.x;
#if CLOTH
  SeamLook seam = seams(n * side, v_position);
  vec4 thread = threads(n * side, v_position);
  vec3 slope = seam.slope + thread.xyz;
  n = normalize(n - slope * (side / max(1.0, length(slope) / 1.5)));   // where a pixel has hardly any of a triangle
#endif
  float facing = dot(n, to_eye);
  if (facing < 0.02) n = normalize(n + to_eye * (0.02 - facing));
  facing = max(facing, 0.02);

  float key = dot(n, key_light);
  float towards = key < 0.0 ? -1.0 : 1.0;
  vec3 round = bend(v_position);
  vec3 from = v_position + n * towards * 0.002 + round * step(0.0, dot(round, n) * towards);
#if CLOTH
  float lit = key_visible(from, smooth_normal);
#else
  float lit = key > 0.0 ? key_visible(from, smooth_normal) : 0.0;
#endif
  float fill = max(dot(n, fill_light) * 0.8 + 0.2, 0.0);
  float rim = max(dot(n, rim_light), 0.0) * (0.25 + 0.75 * pow(1.0 - facing, 2.0));
  float bounce = 0.5 - 0.5 * n.y;
  float openness = clamp(sky / (0.5 + 0.5 * n.y + 0.08), 0.0, 1.0);

  vec3 light = vec3(1.0, 0.965, 0.91) * 1.0 * max(key, 0.0) * lit;
  light += vec3(0.92, 0.96, 1.0) * 0.62 * sky;
  light += vec3(0.86, 0.93, 1.0) * 0.20 * fill * (0.15 + 0.85 * openness);
  light += vec3(1.0, 0.97, 0.93) * 0.30 * bounce * (0.30 + 0.70 * openness);
  light += vec3(0.95, 0.98, 1.0) * 0.40 * rim * openness;
#if CLOTH
  vec3 base = v_colour;
  if (pictured) {
    vec4 shown = texture(picture, v_picture_at);
    base = mix(base, shown.rgb, shown.a);
  }
  if (side < 0.0) base = mix(base, vec3(dot(base, vec3(0.2126, 0.7152, 0.0722))), 0.18) * 0.80;
  base = mix(base * yarn_tone() * thread.w * seam.shade, thread_of(base), seam.thread);
  base = mix(base, vec3(0.72, 0.03, 0.03), open_seam());
  light += vec3(1.0, 0.93, 0.82) * (0.18 * max(-key, 0.0) * lit + 0.10 * through);   // shines through
  vec3 sheen = mix(vec3(1.0), base, 0.7) * look.y * 0.5 * pow(1.0 - facing, 3.0) * (openness + max(key, 0.0) * lit);
  float shine = 1.0 * lit * gloss(n, key_light, to_eye, look.x) +
                0.35 * openness * (gloss(n, fill_light, to_eye, look.x) + gloss(n, rim_light, to_eye, look.x));
  pixel = developed(base * light + sheen + shine);
#else
  vec3 half_way = normalize(key_light + to_eye);
  float gloss = 0.035 * pow(max(dot(n, half_way), 0.0), 14.0) * lit;
  float edge = 0.05 * pow(1.0 - facing, 4.0) * openness;
  pixel = developed(body_colour * light + gloss + edge);
#endif
}
