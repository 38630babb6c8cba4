layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 9) in vec2 sky;
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
  v_sky = sky;
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
