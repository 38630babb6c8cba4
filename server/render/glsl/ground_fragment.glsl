// The ground has the backdrop's colour and only catches shadows, so no horizon cuts the picture.
in vec3 v_position;
in float v_sky;
uniform vec4 ground;                  // xz of its middle, radius of the shadows, height
uniform bool shadow_only;             // black that covers as much as the shadow darkens
out vec4 pixel;
void main() {
  float away = length(v_position.xz - ground.xy) / ground.z;
  float fade = 1.0 - smoothstep(0.15, 1.0, away);
  float lit = fade <= 0.0 ? 1.0 : key_visible_softly(v_position, vec3(0.0, 1.0, 0.0), 26.0 * key_texel, 6.2832 * noise_at(gl_FragCoord.xy));
  vec3 shade = mix(vec3(0.44, 0.455, 0.49), vec3(1.0), clamp(v_sky, 0.0, 1.0)) * mix(vec3(0.80, 0.81, 0.835), vec3(1.0), lit);
  shade = mix(vec3(1.0), shade, fade);
  if (shadow_only) pixel = vec4(vec3(0.0), 1.0 - pow(dot(shade, vec3(1.0 / 3.0)), 1.0 / 2.2));
  else pixel = developed(backdrop(gl_FragCoord.xy) * shade);
}
