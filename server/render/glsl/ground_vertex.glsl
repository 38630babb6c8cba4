layout(location = 0) in vec3 position;
uniform mat4 camera_matrix;
out vec3 v_position;
out float v_sky;
void main() {
  v_position = position;
  v_sky = sky_on_ground(position);
  gl_Position = camera_matrix * vec4(position, 1.0);
}
