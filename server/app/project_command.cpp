#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/base/aabb.h"
#include "core/base/processors.h"
#include "core/base/text.h"
#include "core/base/write_file.h"
#include "core/body/measure/stance.h"
#include "core/json/tree.h"
#include "core/project/bodies.h"
#include "core/project/create/create.h"
#include "core/project/resolve/resolve.h"
#include "server/app/bring_file.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/layer_option.h"
#include "server/app/mesh_reader.h"
#include "server/app/pattern_bytes.h"
#include "server/documents/arrangement.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

std::string side_text(const std::vector<project::ProjectSeamEdge>& side) {
  std::string text;
  for (const project::ProjectSeamEdge& e : side) text += (text.empty() ? "" : " + ") + e.piece + "." + e.edge;
  return text;
}

void print_json(const create::NewProject& made, const ProjectNewOptions& options) {
  std::vector<json::JsonValue> proposals, notes, told = create::seams_json(made);
  for (std::size_t i = 0; i < made.proposals.size(); ++i) {
    json::JsonValue proposal = std::move(told[i]);
    std::get<std::vector<json::JsonMember>>(proposal.data).push_back({"accepted", bool{made.accepted[i]}});
    proposals.push_back(std::move(proposal));
  }
  for (const std::string& note : made.notes) notes.emplace_back(note);
  std::printf("%s", json::write_json(std::vector<json::JsonMember>{
                                         {"file", options.out},
                                         {"pieces", static_cast<double>(made.project.pieces.size())},
                                         {"seams", static_cast<double>(made.project.seams.size())},
                                         {"proposals", proposals},
                                         {"notes", notes}})
                        .c_str());
}

void print_text(const create::NewProject& made, const ProjectNewOptions& options) {
  std::printf("%s: %zu pieces, %zu seams\n", options.out.c_str(), made.project.pieces.size(),
              made.project.seams.size());
  for (std::size_t i = 0; i < made.proposals.size(); ++i) {
    const seams::SeamProposal& p = made.proposals[i];
    const project::ProjectSeam seam = create::project_seam(made.pattern, p.seam);
    std::printf("%s %s: %s to %s, %s mm to %s mm, confidence %s\n", made.accepted[i] ? "seam" : "proposed",
                seam.id.c_str(), side_text(seam.a).c_str(), side_text(seam.b).c_str(),
                fixed_text(p.length_a, 1).c_str(), fixed_text(p.length_b, 1).c_str(),
                fixed_text(p.confidence, 2).c_str());
  }
  for (const std::string& note : made.notes) std::printf("note: %s\n", note.c_str());
}

/// A person's stance in the file, if it is one, and the box around it in the project.
struct FoundBody {
  std::optional<measure::BodyStance> stance;
  Aabb3 box;  // m

  bool turned() const { return stance && !project::turned_words(*stance).empty(); }
};

/// A person is set upright and looks to the front, as on the page, whatever its file has: pieces are arranged
/// and judged so. Who does so already stays where the file has it, since a specification tells its places
/// around that, and what is no person stays as well.
Result<FoundBody> find_body(const std::string& file) {
  mesh_import::RepairedMesh read = TRY(own_mesh_importer().file(file, {.unit_in_m = 1}));
  const Result<measure::StandingBody> standing = measure::stand_body(std::move(read.mesh));
  if (!standing) {
    read = TRY(own_mesh_importer().file(file, {}));
    return FoundBody{{}, bounding_box(read.mesh.vertices)};
  }
  FoundBody found{standing->stance, bounding_box(standing->mesh.vertices)};
  if (found.turned()) return found;
  found.box.low.y += found.stance->floor;
  found.box.high.y += found.stance->floor;
  return found;
}

/// The document's body as it was found.
void place_body(const FoundBody& found, create::NewProject& made) {
  if (!found.stance) return;
  project::ProjectBody& body = made.project.bodies.front();
  project::stand_up(body, *found.stance);
  if (!found.turned()) return;
  body.translation.y = -std::round(found.stance->floor * 1e6) / 1e6 + 0.0;
  made.notes.push_back("the body was turned: " + project::turned_words(*found.stance));
}

Result<create::NewProject> make(const ProjectNewOptions& options) {
  const std::string text = TRY(pattern_bytes(options.pattern));
  const FoundBody body = TRY(find_body(options.body));
  create::NewProjectSettings settings;
  settings.dxf.layers = TRY(read_layers(options.layers));
  if (!options.layers.empty() && create::is_specification(text))
    return Error{"pattern.no_layers", "a GarmentCode specification has no layers", options.pattern};
  settings.name = fs::path(options.pattern).stem().string();
  settings.pattern_file = fs::path(options.pattern).filename().string();
  settings.body_file = fs::path(options.body).filename().string();
  settings.body = body.box;
  if (!options.no_seams) settings.accept_seams = options.accept_seams;
  Result<create::NewProject> made = create::new_project(text, settings, on_all_processors());
  if (made) {
    place_body(body, *made);
    return made;
  }
  Error error = with_way_out(made.error(), text, options.pattern);
  error.where = options.pattern + (error.where.empty() ? "" : ": " + error.where);
  return error;
}

/// Writes the document, and brings the files that it names beside it.
Status keep(const create::NewProject& made, const ProjectNewOptions& options) {
  const fs::path folder = fs::absolute(options.out).parent_path();
  std::error_code failure;
  fs::create_directories(folder, failure);
  const bool names_pattern = std::any_of(made.project.pieces.begin(), made.project.pieces.end(),
                                         [](const project::ProjectPiece& p) { return p.from.has_value(); });
  if (names_pattern) {
    TRY(bring_file(options.pattern, folder));
  }
  TRY(bring_file(options.body, folder));
  return write_file(options.out, project::write_project(made.project));
}

/// Pieces that were sewn come to stand around the body, as after an import on the page: rows before and
/// behind it are no place to put a garment on from. One that cannot be arranged yet is a project all the
/// same. REQUIRES that the files it names are in `folder`.
void arrange_sewn(create::NewProject& made, const fs::path& folder) {
  const Result<drape::DrapeInput> input =
      resolve::resolve_project(made.project, resolve::files_in(folder, own_mesh_importer()));
  const Result<arrange::Arrangement> arranged =
      input ? documents::arrangement_of(*input) : Result<arrange::Arrangement>(input.error());
  if (arranged)
    documents::take_arrangement(*arranged, input->pattern, made.project);
  else
    made.notes.push_back("the pieces stand in rows, since they cannot be arranged: " +
                         to_string(arranged.error()));
}

}  // namespace

ExitCode project_new_command(const ProjectNewOptions& options) {
  Result<create::NewProject> made = make(options);
  if (!made) return fail(made.error(), options.json);
  if (Status kept = keep(*made, options); !kept) return fail(kept.error(), options.json);
  const bool sewn = std::find(made->accepted.begin(), made->accepted.end(), true) != made->accepted.end();
  if (sewn) {
    arrange_sewn(*made, fs::absolute(options.out).parent_path());
    if (Status kept = write_file(options.out, project::write_project(made->project)); !kept)
      return fail(kept.error(), options.json);
  }
  options.json ? print_json(*made, options) : print_text(*made, options);
  return kDone;
}

}  // namespace toile::app
