// Each sky light has its own small depth map. Light that comes from all over is their sum, taken per vertex:
// the meshes are fine enough for soft light, and 25 look-ups per pixel would be too dear on a processor. It
// does not turn with the camera: a scene's pictures share it.
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
