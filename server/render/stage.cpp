#include "server/render/stage.h"

#include <utility>

#include "server/render/picture_texture.h"
#include "server/render/shaders.h"
#include "server/render/studio.h"

namespace toile::render {
namespace {

constexpr int kGroundCells = 64;      // a side
constexpr double kGroundReach = 2.2;  // radius of caught shadows, of the scene's own
constexpr float kSkyBlur = 5;         // texels of a sky map, on the ground

void set_sky(const GlFunctions& gl, const GlProgram& program, const SkyLight& sky) {
  program.use();
  gl.Uniform1i(program.at("sky_map"), 0);
  gl.UniformMatrix4fv(program.at("sky_matrix"), shaders::kSkyLights, GL_FALSE, sky.matrices[0].data());
  gl.Uniform4fv(program.at("sky_light"), shaders::kSkyLights, sky.lights[0].data());
  gl.Uniform1f(program.at("sky_offset"), sky.offset);
  gl.Uniform1f(program.at("sky_blur"), kSkyBlur * sky.offset);
}

}  // namespace

Stage::Stage(const GlFunctions& gl, const Programs& programs, const Scene& scene)
    : gl_(gl), programs_(programs), box_(whole_box(scene)), scope_(gl) {
  upload_cloth_and_bodies(scene);
  upload_ground(scene);
  light();
}

Vec3 Stage::middle() const { return box_.empty() ? Vec3{} : box_.middle(); }

double Stage::reach() const { return kGroundReach * (box_.empty() ? 0.5 : length(box_.size()) * 0.5); }

void Stage::upload_cloth_and_bodies(const Scene& scene) {
  ClothSurface cloth = cloth_surface(scene.cloth);
  cloth_ = upload_cloth(scope_, cloth);
  runs_ = std::move(cloth.runs);
  if (scene.cloth.textures != nullptr) {
    for (const auto& image : scene.cloth.textures->images)
      pictures_.push_back(upload_picture(scope_, image->read.picture));
  }
  for (const BodyView& body : scene.bodies)
    bodies_.push_back(upload_indexed(scope_, body_vertices(*body.mesh), body.mesh->triangles, body.colour));
}

/// A grid about the scene, since soft light is taken per vertex. It grows coarser outwards.
void Stage::upload_ground(const Scene& scene) {
  const auto height = static_cast<float>(floor_height(scene));
  const auto along = [&](int i) {
    const double s = 2.0 * i / kGroundCells - 1;
    return reach() * s * (0.3 + 0.7 * s * s);
  };
  std::vector<BodyVertex> vertices;
  std::vector<Tri> triangles;
  for (int j = 0; j <= kGroundCells; ++j) {
    for (int i = 0; i <= kGroundCells; ++i) {
      vertices.push_back(
          {{static_cast<float>(middle().x + along(i)), height, static_cast<float>(middle().z + along(j))},
           {0, 1, 0}});
      if (i == kGroundCells || j == kGroundCells) continue;
      const Index a = j * (kGroundCells + 1) + i, b = a + 1, c = a + kGroundCells + 1, d = c + 1;
      triangles.push_back({a, c, b});
      triangles.push_back({b, c, d});
    }
  }
  ground_ = upload_indexed(scope_, vertices, triangles, {});
}

void Stage::draw_casters() const {
  draw(gl_, cloth_);
  gl_.Enable(GL_CULL_FACE);
  for (const DrawnSurface& body : bodies_) draw(gl_, body);
  gl_.Disable(GL_CULL_FACE);
}

/// The sky's depth maps, and from them what reaches each vertex.
void Stage::light() {
  const SkyLight sky = sky_over(box_);
  GlScope maps(gl_);  // nobody asks for them after that
  const GLuint map = depth_map(maps, kSkyTileSide * shaders::kSkyTiles);
  bind_depth_target(maps, map);
  programs_.depth.use();
  for (int i = 0; i < shaders::kSkyLights; ++i) {
    gl_.Viewport(i % shaders::kSkyTiles * kSkyTileSide, i / shaders::kSkyTiles * kSkyTileSide, kSkyTileSide,
                 kSkyTileSide);
    gl_.UniformMatrix4fv(programs_.depth.at("light_matrix"), 1, GL_FALSE, sky.matrices[i].data());
    draw_casters();
  }
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, map);
  set_sky(gl_, programs_.sky, sky);
  add_sky(scope_, cloth_);
  for (const DrawnSurface& body : bodies_) add_sky(scope_, body);
  set_sky(gl_, programs_.ground_sky, sky);
  add_sky(scope_, ground_);
}

}  // namespace toile::render
