layout(location = 0) in vec3 position;
layout(location = 9) in vec2 sky;
uniform mat4 camera_matrix;
out vec3 v_position;
out float v_sky;
void main() {
  v_position = position;
  v_sky = sky.x;
  gl_Position = camera_matrix * vec4(position, 1.0);
}
