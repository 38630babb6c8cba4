#include "core/project/resolve/resolve.h"

#include <algorithm>
#include <utility>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/json/tree.h"
#include "core/pattern/validate.h"
#include "core/project/resolve/fabrics.h"
#include "core/project/resolve/pattern_names.h"
#include "core/project/resolve/pieces.h"
#include "core/project/resolve/sewn_parts.h"
#include "core/project/resolve/solid_bodies.h"

namespace toile::resolve {
namespace {

/// The first id that stands twice, as an error at the later place. An empty id stands for none.
Status check_unique(const std::vector<std::string>& ids, const std::string& list) {
  std::vector<std::pair<std::string_view, std::size_t>> sorted;
  for (std::size_t i = 0; i < ids.size(); ++i) sorted.emplace_back(ids[i], i);
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first.empty() || sorted[i].first != sorted[i - 1].first) continue;
    return Error{"project.duplicate_id",
                 "the id " + in_quotes(sorted[i].first) + " stands twice in this list",
                 json::pointer_to(json::pointer_to(list, sorted[i].second), "id")};
  }
  return {};
}

Status check_ids(const project::Project& project) {
  for (const auto& [ids, list] :
       {std::pair{ids_of(project.pieces), "/pieces"}, std::pair{ids_of(project.fabrics), "/fabrics"},
        std::pair{ids_of(project.seams), "/seams"}, std::pair{ids_of(project.bodies), "/bodies"},
        std::pair{ids_of(project.attachments), "/attachments"},
        std::pair{ids_of(project.buttons), "/buttons"}, std::pair{ids_of(project.elastics), "/elastics"},
        std::pair{ids_of(project.folds), "/folds"}, std::pair{ids_of(project.cushions), "/cushions"}}) {
    if (Status unique = check_unique(ids, list); !unique) return unique;
  }
  return {};
}

solver::constraints::AirDrag air_of(const project::ProjectAir& given) {
  return {given.density_kg_m3, given.drag_across, given.drag_along, given.wind_m_s};
}

paper::PaperSettings paper_of(const project::ProjectPaper& given) {
  paper::PaperSettings paper;
  paper.time_step = given.time_step_s.value_or(paper.time_step);
  paper.damping = given.damping.value_or(paper.damping);
  paper.passes = given.passes.value_or(paper.passes);
  paper.reflection = given.reflection.value_or(paper.reflection);
  paper.load = given.load_n_m.value_or(paper.load);
  if (given.clearance_mm) paper.clearance = metres_from_mm(*given.clearance_mm);
  return paper;
}

drape::DrapeSettings settings_of(const project::ProjectSettings& given) {
  drape::DrapeSettings settings;
  settings.particle_distance = metres_from_mm(given.particle_distance_mm);
  settings.time_step = given.time_step_s;
  settings.gravity = given.gravity;
  settings.sew_time = given.sew_time_s;
  settings.settle_speed = metres_from_mm(given.settle_speed_mm_s);
  settings.max_time = given.max_time_s;
  settings.frame_interval = given.frame_interval_steps;
  settings.dress = given.start == "auto";
  settings.ground = given.ground;
  const bool dynamic = given.mode == "dynamic";
  settings.mode = dynamic ? drape::DrapeMode::kDynamic : drape::DrapeMode::kDrape;
  settings.until_settled = given.end.empty() ? !dynamic : given.end == "settled";
  if (given.solver == "paper") settings.method = drape::DrapeMethod::kPaper;
  if (given.paper) settings.paper = paper_of(*given.paper);
  const project::ProjectAir still;
  if (given.air || dynamic) settings.air = air_of(given.air.value_or(still));
  return settings;
}

}  // namespace

Result<drape::DrapeInput> resolve_project(const project::Project& project, OpenedFiles& files) {
  TRY(check_ids(project));
  drape::DrapeInput input;
  input.name = project.name;
  input.settings = settings_of(project.settings);
  TRY(add_fabrics(project, input));

  std::vector<pattern::Panel> panels = TRY(panels_of(project.pieces, files));
  input.pattern.panels = std::move(panels);
  const PatternNames names(input.pattern);
  TRY(add_seams(project.seams, names, input.pattern.seams));
  if (Status valid = pattern::validate(input.pattern); !valid) {
    return json::error_at("/seams", valid.error());  // each piece by itself has been found valid
  }
  TRY(add_notions(project, names, input.notions));
  TRY(follow_used_lines(input.notions, input.pattern));
  TRY(add_bodies(project.bodies, files, input.bodies));
  TRY(add_told_by_bodies(project, names, input));
  return input;
}

Result<drape::DrapeInput> resolve_project(const project::Project& project, const ProjectFiles& files) {
  OpenedFiles opened(files);
  return resolve_project(project, opened);
}

Result<ResolvedProject> read_project(const std::filesystem::path& path,
                                     const mesh_import::MeshImporter& importer, const FileNote& note) {
  const auto in_document = [&](const Error& error) {
    return json::error_at(clipped(path.string(), 300), error);
  };
  const std::string text = TRY(read_project_text(path));
  Result<project::Project> project = project::parse_project(text);
  if (!project) return in_document(project.error());
  ProjectFiles files = files_in(path.parent_path(), importer);
  ProjectFiles noted = files;  // the note may not outlive this call
  if (note) {
    noted.dxf_text = [&](const std::string& name) {
      Result<std::string> bytes = files.dxf_text(name);
      if (bytes) note(name, *bytes);
      return bytes;
    };
  }
  Result<drape::DrapeInput> input = resolve_project(*project, noted);
  if (!input) return in_document(input.error());
  return ResolvedProject{std::move(*project), std::move(*input), std::move(files), path};
}

Result<image::Textures> read_textures(const ResolvedProject& read) {
  Result<image::Textures> textures = read_textures(read.project, read.input.pattern, read.files);
  if (!textures) return json::error_at(clipped(read.path.string(), 300), textures.error());
  return textures;
}

}  // namespace toile::resolve
