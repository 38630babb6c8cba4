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
