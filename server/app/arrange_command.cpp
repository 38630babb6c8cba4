#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/arrange/arrange.h"
#include "core/base/units.h"
#include "core/base/write_file.h"
#include "core/mesh/make_panel_meshes.h"
#include "proto/cpp/json_codec.h"
#include "proto/cpp/project_places.h"
#include "proto/cpp/project_resolve.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/findings_text.h"

namespace toile {
namespace {

/// Holds of an arrangement before this one are replaced; others stay.
void take_places(const Arrangement& made, const Pattern& pattern, Project& project) {
  for (std::size_t p = 0; p < project.pieces.size(); ++p) {
    project.pieces[p].placement = project_placement(made.placements[p]);
  }
  std::erase_if(project.attachments, [](const ProjectAttachment& a) { return a.id.starts_with("hold_"); });
  for (const Attachment& a : made.attachments) project.attachments.push_back(project_attachment(pattern, a));
}

JsonValue arrangement_json(const Arrangement& made, const std::string& file) {
  std::vector<JsonValue> pieces, findings, holds;
  for (const ArrangedPiece& p : made.pieces) {
    pieces.push_back(std::vector<JsonMember>{{"id", p.id}, {"place", p.where}});
  }
  for (const Attachment& a : made.attachments) holds.emplace_back(a.id);
  for (const Finding& f : made.findings) findings.push_back(finding_json(f));
  return std::vector<JsonMember>{
      {"file", file}, {"pieces", pieces}, {"holds", holds}, {"findings", findings}};
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
  const Result<DrapeInput> input =
      resolve_project(*project, files_in(std::filesystem::path(options.project).parent_path()));
  if (!input) return fail(input.error(), options.json);
  const Result<PanelMeshes> meshes = make_panel_meshes(input->pattern, input->settings.particle_distance, {});
  if (!meshes) return fail(meshes.error(), options.json);
  const Result<Arrangement> made = arrange({input->pattern, *meshes, input->bodies});
  if (!made) return fail(made.error(), options.json);
  take_places(*made, input->pattern, *project);
  const std::string& file = options.out.empty() ? options.project : options.out;
  if (Status written = write_file(file, write_project(*project)); !written)
    return fail(written.error(), options.json);
  if (options.json) {
    std::printf("%s", write_json(arrangement_json(*made, file)).c_str());
  } else {
    print_arrangement(*made, file);
  }
  const std::optional<Error> refused = first_error(made->findings);
  return refused ? fail(*refused, options.json) : kDone;
}

}  // namespace toile
