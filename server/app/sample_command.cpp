#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/base/units.h"
#include "core/base/write_file.h"
#include "core/body/mannequin/mannequin.h"
#include "core/body/measure/stance.h"
#include "core/draft/garments.h"
#include "core/exports/write_obj.h"
#include "core/json/tree.h"
#include "core/project/bodies.h"
#include "core/project/resolve/resolve.h"
#include "core/sample/sample_project.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/measure_option.h"
#include "server/app/mesh_reader.h"
#include "server/documents/arrangement.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

constexpr int kTriangles = 3300;  // of a sample's mannequin
constexpr const char* kBodyFile = "body.obj";

struct Dressed {
  draft::Wearer wearer;
  project::ProjectBody body;
};

/// The first option that says for whom it is drafted; empty: none.
std::string named_wearer(const SampleOptions& options) {
  if (!options.body.empty()) return "--body";
  if (!options.preset.empty()) return "--preset";
  if (!options.sex.empty()) return "--sex";
  const auto given = std::find_if(options.measures_cm.begin(), options.measures_cm.end(),
                                  [](const std::optional<double>& cm) { return cm.has_value(); });
  if (given == options.measures_cm.end()) return {};
  return measure_option(static_cast<measure::Measure>(given - options.measures_cm.begin()));
}

/// What nobody wears is drafted for nobody: a wearer that is named has no say in it, and is told so.
Status check_wearer(const SampleOptions& options, const draft::GarmentKind& kind) {
  const std::string named = named_wearer(options);
  if (!kind.preset.empty() || named.empty()) return {};
  return Error{"usage.wearer",
               "nobody wears the sample " + options.name + ", so it is drafted for no body: leave " + named +
                   " out, or take a sample that is worn; toile sample lists for whom each is drafted",
               named};
}

/// The mannequin that was asked for, or the garment's own.
Result<Dressed> mannequin_of(const SampleOptions& options, const draft::GarmentKind& kind) {
  Dressed out;
  project::ProjectMannequin& asked = out.body.mannequin.emplace();
  const bool own = options.preset.empty() && options.sex.empty();
  asked.preset = own ? std::string(kind.preset) : options.preset;
  asked.sex = options.sex;
  asked.measures_cm = options.measures_cm;
  asked.triangles = kTriangles;
  const mannequin::MannequinSettings settings = TRY(project::mannequin_settings(asked));
  const mannequin::Mannequin made = TRY(mannequin::make_mannequin(settings));
  out.wearer = TRY(draft::wearer_of(made.measures));
  return out;
}

/// The body of a file, which comes to stand upright in metres beside the document.
Result<Dressed> body_of(const SampleOptions& options) {
  mesh_import::RepairedMesh file = TRY(own_mesh_importer().file(options.body, {.unit_in_m = 1}));
  const measure::StandingBody body = TRY(measure::stand_body(std::move(file.mesh)));
  const measure::BodyMeasures taken = TRY(measure::measure_body(body.mesh));
  Dressed out;
  out.wearer = TRY(draft::wearer_of(taken));
  out.body.file = kBodyFile;
  out.body.unit = "m";
  TRY(exports::write_obj(fs::path(options.out) / kBodyFile, body.mesh.vertices, body.mesh.triangles));
  return out;
}

/// Puts the pieces where they are sewn from, as `toile project arrange` does.
Status arrange(const fs::path& folder, project::Project& project) {
  const drape::DrapeInput input =
      TRY(resolve::resolve_project(project, resolve::files_in(folder, own_mesh_importer())));
  const arrange::Arrangement made = TRY(documents::arrangement_of(input));
  documents::take_arrangement(made, input.pattern, project);
  return {};
}

Status make_sample_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!failure && fs::is_directory(folder)) return {};
  return Error{"usage.out", "cannot make the folder: " + failure.message(), folder.string()};
}

Result<draft::Garment> make(const SampleOptions& options) {
  const draft::GarmentKind* kind = draft::find_garment(options.name);
  if (kind == nullptr) {
    return Error{"usage.sample", "there is no such sample; toile sample lists them", options.name};
  }
  TRY(check_wearer(options, *kind));
  TRY(make_sample_folder(options.out));
  const bool worn = !kind->preset.empty();
  Dressed dressed;
  if (worn) dressed = TRY(options.body.empty() ? mannequin_of(options, *kind) : body_of(options));
  dressed.body.id = "body";
  draft::Garment garment = kind->draft(dressed.wearer);
  const std::optional<project::ProjectBody> body = worn ? std::optional(dressed.body) : std::nullopt;
  sample::SampleProject made = TRY(sample::sample_project(garment, body, options.cloth));
  const fs::path folder(options.out);
  TRY(write_file(folder / made.dxf_name, made.dxf));
  for (const draft::Solid& solid : garment.solids)
    TRY(exports::write_obj(folder / (solid.id + ".obj"), solid.mesh.vertices, solid.mesh.triangles));
  if (worn) TRY(arrange(folder, made.project));
  TRY(write_file(folder / "project.json", project::write_project(made.project)));
  return garment;
}

json::JsonValue garment_json(const draft::Garment& garment, const std::string& out) {
  std::vector<json::JsonValue> girths;
  for (const draft::Girth& g : garment.girths)
    girths.push_back(std::vector<json::JsonMember>{
        {"place", g.place}, {"body_mm", g.body}, {"garment_mm", g.garment}, {"ease_mm", g.ease()}});
  return std::vector<json::JsonMember>{{"file", (fs::path(out) / "project.json").string()},
                                       {"name", garment.title},
                                       {"pieces", static_cast<double>(garment.pattern.panels.size())},
                                       {"seams", static_cast<double>(garment.pattern.seams.size())},
                                       {"girths", girths}};
}

ExitCode list_samples(bool as_json) {
  std::vector<json::JsonValue> list;
  for (const draft::GarmentKind& kind : draft::garment_kinds()) {
    const std::string name(kind.name), summary(kind.summary), preset(kind.preset);
    if (!as_json)
      std::printf("%-14s %s (%s)\n", name.c_str(), summary.c_str(),
                  preset.empty() ? "worn by nobody" : preset.c_str());
    list.push_back(std::vector<json::JsonMember>{{"name", name}, {"summary", summary}, {"preset", preset}});
  }
  if (as_json) std::printf("%s", json::write_json(std::vector<json::JsonMember>{{"samples", list}}).c_str());
  return kDone;
}

}  // namespace

ExitCode sample_command(const SampleOptions& options) {
  if (options.name.empty()) return list_samples(options.json);
  if (options.out.empty())
    return fail({"usage.arguments", "say with --out where the sample goes", ""}, options.json);
  const Result<draft::Garment> made = make(options);
  if (!made) return fail(made.error(), options.json);
  if (options.json) {
    std::printf("%s", json::write_json(garment_json(*made, options.out)).c_str());
    return kDone;
  }
  std::printf("%s: %zu pieces, %zu seams, in %s\n", made->title.c_str(), made->pattern.panels.size(),
              made->pattern.seams.size(), options.out.c_str());
  for (const draft::Girth& g : made->girths)
    std::printf("  %-10s body %6.1f cm, garment %6.1f cm, ease %5.1f cm\n", g.place.c_str(), g.body / 10,
                g.garment / 10, g.ease() / 10);
  return kDone;
}

}  // namespace toile::app
