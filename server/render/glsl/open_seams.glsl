// Goes behind seams.glsl: how much of a pixel lies on a seam that did not close, 0 to 1.
float open_seam() {
  float open = 0.0;
  vec4 dx = dFdx(v_line_distance), dy = dFdy(v_line_distance);
  for (int i = 0; i < 4; ++i) {
    if (v_line_distance[i] > kReach) continue;
    float half_pixel = 0.5 * max(length(vec2(dx[i], dy[i])), 1e-6);
    float on_line = 1.0 - smoothstep(0.0012, 0.0020, v_line_distance[i] - half_pixel);
    open = max(open, smoothstep(0.5, 1.0, -v_line_kind[i]) * on_line);
  }
  return open;
}
