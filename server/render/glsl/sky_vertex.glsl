layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec2 sky;
void main() {
#if GROUND
  sky = vec2(sky_on_ground(position), 0.0);
#else
  sky = sky_light_at(position, normal);
#endif
}
