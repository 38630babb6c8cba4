#include <cstdio>

#include "core/body/mannequin.h"
#include "core/export/write_obj.h"
#include "proto/cpp/json_codec.h"
#include "server/app/commands.h"
#include "server/app/console.h"

namespace toile {

ExitCode body_command(const BodyOptions& options) {
  constexpr double kMetres = 1e-2;  // per cm
  MannequinSettings settings;
  settings.height = options.height_cm * kMetres;
  settings.bust = options.bust_cm * kMetres;
  settings.waist = options.waist_cm * kMetres;
  settings.hip = options.hip_cm * kMetres;
  settings.triangle_count = options.triangles;
  const Result<TriangleMesh> mesh = make_mannequin(settings);
  if (!mesh) return fail(mesh.error(), options.json);
  if (Status written = write_obj(options.out, mesh->vertices, mesh->triangles); !written) {
    return fail(written.error(), options.json);
  }
  const std::size_t vertices = mesh->vertices.size(), triangles = mesh->triangles.size();
  if (options.json) {
    const std::vector<JsonMember> figures{{"file", options.out},
                                          {"vertices", static_cast<double>(vertices)},
                                          {"triangles", static_cast<double>(triangles)}};
    std::printf("%s", write_json(figures).c_str());
  } else {
    std::printf("%s: %zu vertices, %zu triangles, metres\n", options.out.c_str(), vertices, triangles);
  }
  return kDone;
}

}  // namespace toile
