#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/arrange/arrange.h"
#include "core/base/units.h"
#include "core/base/write_file.h"
#include "core/json/tree.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/project/create/places.h"
#include "core/project/resolve/resolve.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/findings_text.h"
#include "server/app/mesh_reader.h"
#include "server/documents/arrangement.h"

namespace toile {
namespace {

JsonValue answer_json(const Arrangement& made, const std::string& file) {
  std::vector<JsonMember> members{{"file", file}};
  for (JsonMember& member : arrangement_members(made)) members.push_back(std::move(member));
  return members;
}

void print_arrangement(const Arrangement& made, const std::string& file) {
  for (const ArrangedPiece& p : made.pieces) std::printf("piece %s: %s\n", p.id.c_str(), p.where.c_str());
  for (const Attachment& a : made.attachments)
    std::printf("%s: at its height until gravity is full\n", a.id.c_str());
  print_findings(made.findings);
  std::printf("%s\n", file.c_str());
}

}  // namespace

ExitCode project_arrange_command(const ProjectArrangeOptions& options) {
  const Result<std::string> text = read_project_text(options.project);
  if (!text) return fail(text.error(), options.json);
  Result<Project> project = parse_project(*text);
  if (!project) return fail(project.error(), options.json);
  Result<DrapeInput> input = resolve_project(
      *project, files_in(std::filesystem::path(options.project).parent_path(), own_mesh_importer()));
  if (!input) return fail(input.error(), options.json);
  const Result<PanelMeshes> meshes = make_panel_meshes(input->pattern, input->settings.particle_distance, {});
  if (!meshes) return fail(meshes.error(), options.json);
  const Result<Arrangement> made = arrange({input->pattern, *meshes, input->bodies});
  if (!made) return fail(made.error(), options.json);
  take_arrangement(*made, input->pattern, *project);
  if (options.as == "box") {
    input->placements = made->placements;
    tell_by_boxes(*input, *project);
  }
  const std::string& file = options.out.empty() ? options.project : options.out;
  if (Status written = write_file(file, write_project(*project)); !written)
    return fail(written.error(), options.json);
  if (options.json) {
    std::printf("%s", write_json(answer_json(*made, file)).c_str());
  } else {
    print_arrangement(*made, file);
  }
  const std::optional<Error> refused = first_error(made->findings);
  return refused ? fail(*refused, options.json) : kDone;
}

}  // namespace toile
