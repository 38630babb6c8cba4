#include "tests/garmentcode/to_project.h"

#include <fstream>
#include <iterator>

#include "core/base/write_file.h"
#include "core/project/create/create.h"

namespace toile::test {

Status write_garmentcode_project(const std::filesystem::path& data, const std::string& name,
                                 const std::string& body, const std::vector<std::string>& held,
                                 double particle_distance_mm, const std::filesystem::path& out) {
  const std::filesystem::path file = data / "garmentcode" / (name + "_specification.json");
  std::ifstream in(file, std::ios::binary);
  if (!in) return Error{"test.specification", "no such file", file.string()};
  create::NewProjectSettings settings;
  settings.name = name;
  settings.body_file = body;
  Result<create::NewProject> made =
      create::new_project(std::string{std::istreambuf_iterator<char>(in), {}}, settings);
  if (!made) return made.error();
  project::Project& project = made->project;
  project.bodies[0].unit = "m";
  project.settings.particle_distance_mm = particle_distance_mm;
  for (const project::ProjectPiece& piece : project.pieces)
    for (const std::string& prefix : held)
      if (piece.id.starts_with(prefix))
        project.attachments.push_back({"hold_" + piece.id, piece.id, {}, "height", 1.0});
  std::filesystem::create_directories(out);
  std::filesystem::copy_file(data / "bodies" / body, out / body,
                             std::filesystem::copy_options::overwrite_existing);
  return write_file(out / "project.json", project::write_project(project));
}

}  // namespace toile::test
