#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/arrange/arrange.h"
#include "core/base/units.h"
#include "core/base/write_file.h"
#include "core/drape/drape_start.h"
#include "core/drape/worn_part.h"
#include "core/json/tree.h"
#include "core/project/create/places.h"
#include "core/project/resolve/resolve.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/findings_text.h"
#include "server/app/mesh_reader.h"
#include "server/documents/arrangement.h"

namespace toile::app {
namespace {

json::JsonValue answer_json(const arrange::Arrangement& made, const std::string& file) {
  std::vector<json::JsonMember> members{{"file", file}};
  for (json::JsonMember& member : documents::arrangement_members(made)) members.push_back(std::move(member));
  return members;
}

void print_arrangement(const arrange::Arrangement& made, const std::string& file) {
  for (const arrange::ArrangedPiece& p : made.pieces)
    std::printf("piece %s: %s\n", p.id.c_str(), p.where.c_str());
  for (const sewing::Attachment& a : made.attachments)
    std::printf("%s: at its height until gravity is full\n", a.id.c_str());
  print_findings(made.findings);
  std::printf("%s\n", file.c_str());
}

/// Why no drape would begin from there: what the look at the start refuses. Where a garment is put on a
/// person (core/drape/drape_start.h), the drape sees to what is wrong with where its pieces stand: that is
/// told, and tried there, once.
std::optional<Error> still_refused(const arrange::Arrangement& made, drape::DrapeInput& input) {
  if (!preflight::first_error(made.findings)) return std::nullopt;
  input.placements = made.placements;
  const drape::DrapeInput worn = drape::worn_part(input);
  Result<drape::DrapeStart> start = drape::prepare_start(worn, {});
  if (!start) return start.error();
  if (drape::may_put_on(worn, *start))
    std::erase_if(start->findings, [](const preflight::Finding& f) {
      return preflight::traits_of(f.kind).cause == preflight::Cause::kPlacement;
    });
  return preflight::first_error(start->findings);
}

}  // namespace

ExitCode project_arrange_command(const ProjectArrangeOptions& options) {
  const Result<std::string> text = resolve::read_project_text(options.project);
  if (!text) return fail(text.error(), options.json);
  Result<project::Project> project = project::parse_project(*text);
  if (!project) return fail(project.error(), options.json);
  Result<drape::DrapeInput> input = resolve::resolve_project(
      *project, resolve::files_in(std::filesystem::path(options.project).parent_path(), own_mesh_importer()));
  if (!input) return fail(input.error(), options.json);
  const Result<arrange::Arrangement> made = documents::arrangement_of(*input);
  if (!made) return fail(made.error(), options.json);
  documents::take_arrangement(*made, input->pattern, *project);
  if (options.as == "box") {
    input->placements = made->placements;
    create::tell_by_boxes(*input, *project);
  }
  const std::string& file = options.out.empty() ? options.project : options.out;
  if (Status written = write_file(file, project::write_project(*project)); !written)
    return fail(written.error(), options.json);
  if (options.json) {
    std::printf("%s", json::write_json(answer_json(*made, file)).c_str());
  } else {
    print_arrangement(*made, file);
  }
  const std::optional<Error> refused = still_refused(*made, *input);
  return refused ? fail(*refused, options.json) : kDone;
}

}  // namespace toile::app
