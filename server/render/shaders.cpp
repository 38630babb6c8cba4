#include "server/render/shaders.h"

namespace toile::render::shaders {

const char* const kVersion = "#version 330 core\n#define SKY_TILES 5\n#define SKY_LIGHTS 25\n";
static_assert(kSkyTiles == 5 && kSkyLights == 25, "kVersion repeats these numbers");

const char* const kDepthVertex = R"(
layout(location = 0) in vec3 position;
uniform mat4 light_matrix;
void main() { gl_Position = light_matrix * vec4(position, 1.0); }
)";

const char* const kDepthFragment = R"(
void main() {}
)";

// Each sky light has its own small depth map. Light that comes from all over is their sum, taken per vertex:
// the meshes are fine enough for soft light, and 25 look-ups per pixel would be too dear on a processor.
const char* const kSky = R"(
uniform mat4 sky_matrix[SKY_LIGHTS];
uniform vec4 sky_light[SKY_LIGHTS];   // towards the light; w: its share
uniform sampler2DShadow sky_map;
uniform float sky_offset;             // m, off the surface, about a texel of a sky map
uniform float sky_blur;               // m, on the ground

float sky_tap(int i, vec3 q) {
  if (any(greaterThan(abs(q.xy), vec2(0.985)))) return 1.0;   // outside of all that casts
  q.z = min(q.z, 0.995);                                      // or behind it
  vec2 tile = vec2(float(i % SKY_TILES), float(i / SKY_TILES));
  vec2 at = (tile + q.xy * 0.5 + 0.5) / float(SKY_TILES);
  return textureLod(sky_map, vec3(at, q.z * 0.5 + 0.5), 0.0);
}

float sky_visible(int i, vec3 p) { return sky_tap(i, (sky_matrix[i] * vec4(p, 1.0)).xyz); }

// What reaches level ground from above, blurred so that single lights do not show.
float sky_on_ground(vec3 p) {
  float sum = 0.0;
  for (int i = 0; i < SKY_LIGHTS; ++i) {
    vec3 d = sky_light[i].xyz;
    float visible = 0.0;
    for (int k = 0; k < 5; ++k) {
      float angle = 2.39996 * float(k) + float(i), away = sky_blur * sqrt((float(k) + 0.5) / 5.0);
      visible += sky_visible(i, p + d * sky_offset + away * vec3(cos(angle), 0.0, sin(angle)));
    }
    sum += sky_light[i].w * d.y * visible / 5.0;
  }
  return sum;
}

// x: on the side of n, y: on the other side; 1 is the open sky on a level plane.
vec2 sky_light_at(vec3 p, vec3 n) {
  vec2 sum = vec2(0.0);
  for (int i = 0; i < SKY_LIGHTS; ++i) {
    float c = dot(n, sky_light[i].xyz);
    float side = c < 0.0 ? -1.0 : 1.0;
    vec3 off = p + (n * side + sky_light[i].xyz) * sky_offset;
    float light = sky_light[i].w * abs(c) * sky_visible(i, off);
    sum += c < 0.0 ? vec2(0.0, light) : vec2(light, 0.0);
  }
  return sum;
}
)";

const char* const kStudio = R"(
// 0 to 1 from a cell's whole numbers; integers, so that every machine agrees.
float noise_at(vec2 cell) {
  uint h = uint(int(cell.x)) * 0x9E3779B9u ^ uint(int(cell.y)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return float((h ^ (h >> 15)) >> 8) / 16777216.0;
}

uniform mat4 key_matrix;
uniform vec3 key_light;               // towards the light
uniform sampler2DShadow key_map;
uniform float key_texel;              // of the map, 0 to 1
uniform vec4 image_size;               // xy: pixels

float key_tap(vec3 q, vec2 step, vec2 slope) {
  float depth = min(q.z * 0.5 + 0.5 + dot(step, slope), 0.9999);   // where nothing casts the map holds 1
  return texture(key_map, vec3(q.xy * 0.5 + 0.5 + step, depth));
}

// A tent over the map. Each tap is compared with the depth that the receiver's own plane has there, so that a
// wide, soft edge neither speckles slopes nor needs an offset that would loosen contact. Where the rim and the
// middle agree, so do the taps between.
float key_visible(vec3 p, vec3 plane_normal) {
  vec3 q = (key_matrix * vec4(p, 1.0)).xyz;
  if (any(greaterThan(abs(q.xy), vec2(0.985)))) return 1.0;
  q.z = min(q.z, 0.995);
  vec3 n = mat3(key_matrix) * plane_normal;
  vec2 slope = abs(n.z) > 1e-6 ? clamp(-n.xy / n.z, -5.0, 5.0) : vec2(0.0);
  float unit = 1.7 * key_texel;
  float rim = key_tap(q, vec2(2.0, 0.0) * unit, slope) + key_tap(q, vec2(-2.0, 0.0) * unit, slope) +
              key_tap(q, vec2(0.0, 2.0) * unit, slope) + key_tap(q, vec2(0.0, -2.0) * unit, slope);
  float middle = key_tap(q, vec2(0.0), slope);
  if (rim + middle < 0.001 || rim + middle > 4.999) return middle;
  float near = 0.0, corners = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 along = i < 2 ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    float sign = (i & 1) == 0 ? 1.0 : -1.0;
    near += key_tap(q, along * sign * unit, slope);
    corners += key_tap(q, (along + along.yx * (i < 2 ? 1.0 : -1.0)) * sign * unit, slope);
  }
  return (9.0 * middle + 6.0 * near + 4.0 * corners + 3.0 * rim) / 61.0;
}

// The same, much softer, for the ground: taps on a spiral that turns from pixel to pixel.
float key_visible_softly(vec3 p, vec3 plane_normal, float radius, float turn) {
  vec3 q = (key_matrix * vec4(p, 1.0)).xyz;
  if (any(greaterThan(abs(q.xy), vec2(0.96)))) return 1.0;
  q.z = min(q.z, 0.995);
  vec3 n = mat3(key_matrix) * plane_normal;
  vec2 slope = abs(n.z) > 1e-6 ? clamp(-n.xy / n.z, -5.0, 5.0) : vec2(0.0);
  float sum = 0.0;
  for (int i = 0; i < 12; ++i) {
    float angle = 2.39996 * float(i) + turn;
    vec2 step = vec2(cos(angle), sin(angle)) * sqrt((11.5 - float(i)) / 12.0) * radius;   // the rim first
    sum += key_tap(q, step, slope);
    if (i == 3 && (sum < 0.001 || sum > 3.999)) return sum / 4.0;
  }
  return sum / 12.0;
}

vec3 backdrop(vec2 pixel) {
  vec2 at = pixel / image_size.xy;
  vec3 wall = mix(vec3(0.79, 0.785, 0.775), vec3(0.60, 0.61, 0.63), smoothstep(0.0, 1.0, at.y));
  float glow = exp(-dot((at - vec2(0.5, 0.5)) * vec2(1.7, 1.3), (at - vec2(0.5, 0.5)) * vec2(1.7, 1.3)) * 2.2);
  return wall * (0.86 + 0.20 * glow);
}

// Linear light to display: a soft shoulder, sRGB, and half a step of noise against bands.
vec4 developed(vec3 light) {
  vec3 over = max(light - 0.7, 0.0);
  vec3 c = min(light, 0.7) + 0.3 * (1.0 - exp(-over / 0.3));
  c = mix(12.92 * c, 1.055 * pow(max(c, 1e-5), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
  return vec4(c + (noise_at(gl_FragCoord.xy) - 0.5) / 255.0, 1.0);
}
)";

const char* const kSurfaceVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
#if CLOTH
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 rest;
layout(location = 4) in vec4 line_distance;
layout(location = 5) in vec4 line_along;
layout(location = 6) in vec4 line_kind;
layout(location = 7) in vec3 make;
layout(location = 8) in vec2 picture_at;
out vec3 v_colour;
out vec2 v_rest;
out vec4 v_line_distance;
out vec4 v_line_along;
out vec4 v_line_kind;
out vec3 v_make;
out vec2 v_picture_at;
#endif
uniform mat4 camera_matrix;
uniform vec3 eye;
uniform float sink;                   // m, deeper in the picture: skin that touches cloth stays under it
out vec3 v_position;
out vec3 v_normal;
out vec2 v_sky;
out vec3 v_bend_square, v_bend_cross, v_bend_from;
void main() {
  v_position = position;
  v_normal = normal;
  v_bend_square = normal * normal;
  v_bend_cross = normal * normal.yzx;
  v_bend_from = normal * dot(normal, position);
  v_sky = sky_light_at(position, normal);
#if CLOTH
  v_colour = colour;
  v_rest = rest;
  v_line_distance = line_distance;
  v_line_along = line_along;
  v_line_kind = line_kind;
  v_make = make;
  v_picture_at = picture_at;
#endif
  gl_Position = camera_matrix * vec4(position, 1.0);
  vec4 deeper = camera_matrix * vec4(position + normalize(position - eye) * sink, 1.0);
  gl_Position.z = deeper.z / deeper.w * gl_Position.w;
}
)";

const char* const kSurfaceFragment = R"(
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
  base = mix(base, vec3(0.72, 0.03, 0.03), seam.open);
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
)";

const char* const kGroundVertex = R"(
layout(location = 0) in vec3 position;
uniform mat4 camera_matrix;
out vec3 v_position;
out float v_sky;
void main() {
  v_position = position;
  v_sky = sky_on_ground(position);
  gl_Position = camera_matrix * vec4(position, 1.0);
}
)";

// The ground has the backdrop's colour and only catches shadows, so no horizon cuts the picture.
const char* const kGroundFragment = R"(
in vec3 v_position;
in float v_sky;
uniform vec4 ground;                  // xz of its middle, radius of the shadows, height
uniform bool shadow_only;             // black that covers as much as the shadow darkens
out vec4 pixel;
void main() {
  float lit = key_visible_softly(v_position, vec3(0.0, 1.0, 0.0), 26.0 * key_texel, 6.2832 * noise_at(gl_FragCoord.xy));
  float away = length(v_position.xz - ground.xy) / ground.z;
  float fade = 1.0 - smoothstep(0.15, 1.0, away);
  vec3 shade = mix(vec3(0.44, 0.455, 0.49), vec3(1.0), clamp(v_sky, 0.0, 1.0)) * mix(vec3(0.80, 0.81, 0.835), vec3(1.0), lit);
  shade = mix(vec3(1.0), shade, fade);
  if (shadow_only) pixel = vec4(vec3(0.0), 1.0 - pow(dot(shade, vec3(1.0 / 3.0)), 1.0 / 2.2));
  else pixel = developed(backdrop(gl_FragCoord.xy) * shade);
}
)";

const char* const kBackdropVertex = R"(
void main() {
  vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
  gl_Position = vec4(corner * 2.0 - 1.0, 0.9999, 1.0);
}
)";

const char* const kBackdropFragment = R"(
out vec4 pixel;
void main() { pixel = developed(backdrop(gl_FragCoord.xy)); }
)";

}  // namespace toile::render::shaders
