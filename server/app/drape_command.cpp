#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/analysis/report.h"
#include "core/base/read_file.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/base/write_file.h"
#include "core/exports/report_page.h"
#include "core/exports/write_report.h"
#include "core/image/reduce.h"
#include "core/json/fields/range.h"
#include "core/json/tree.h"
#include "core/project/resolve/resolve.h"
#include "proto/cpp/trace_file.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/drape_once.h"
#include "server/jobs/results.h"
#include "server/movie/film_recorder.h"
#include "server/render/still.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

Status make_results_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!failure && fs::is_directory(folder)) return {};
  return Error{"usage.out",
               "cannot make the folder for the results" + (failure ? ": " + failure.message() : ""),
               folder.string()};
}

std::string percent(double ratio) { return fixed_text(100 * ratio, 2) + "%"; }

/// What may not be as it was meant; notes are for the report.
void print_warnings(const preflight::Findings& findings) {
  bool first = true;
  for (const preflight::Finding& finding : findings) {
    if (finding.severity == preflight::Severity::kNote) continue;
    const std::string where = preflight::where_text(finding);
    std::printf("  %-10s %s%s\n", first ? "warnings" : "", finding.message.c_str(),
                (where.empty() ? "" : " (" + where + ")").c_str());
    first = false;
  }
}

void print_summary(const analysis::Report& report, const DrapeOptions& options) {
  std::printf(
      "%s: %s after %s s of simulated time (%d substeps, %s s by the clock, %s s of processor time)\n",
      report.name.empty() ? "drape" : report.name.c_str(),
      report.settled() ? "settled" : ("not settled (" + drape::to_string(report.stop_reason) + ")").c_str(),
      fixed_text(report.simulated_s, 2).c_str(), report.steps, fixed_text(report.wall_s, 1).c_str(),
      fixed_text(report.cpu_s, 1).c_str());
  std::printf("  cloth      %d particles (%d once sewn), %d triangles; bodies %d triangles\n",
              report.particles, report.sewn_particles, report.triangles, report.body_triangles);
  std::printf("  crossings  %d cloth-body, %d cloth-cloth; worst frame %d and %d\n",
              report.intersections.cloth_body, report.intersections.cloth_cloth,
              report.worst_frame.cloth_body, report.worst_frame.cloth_cloth);
  std::printf("  seams      at most %s mm open\n", fixed_text(report.seam_gap_max_mm, 3).c_str());
  const auto stretch = [](const analysis::StretchFigures& f) {
    return percent(f.tension.p99) + " stretched (" + percent(f.compression.p99) + " pushed)";
  };
  if (report.worn != drape::Worn::kNobody)
    std::printf("  worn       %s\n", std::string(drape::word_of(report.worn)).c_str());
  for (std::size_t i = 0; i < report.fit.size(); ++i)
    std::printf("  %-10s %s\n", i == 0 ? "fit" : "", analysis::fit_text(report.fit[i]).c_str());
  std::printf("  strain     99th percentile: warp %s, weft %s, shear %s degrees\n",
              stretch(report.warp).c_str(), stretch(report.weft).c_str(),
              fixed_text(degrees_from_radians(report.shear.p99), 1).c_str());
  print_warnings(report.findings);
  std::printf("  speed      %s mm/s at most\n", fixed_text(mm_from_metres(report.max_speed), 2).c_str());
  std::printf("  results    %s\n", options.out.c_str());
}

ExitCode exit_code_of(const drape::DrapeResult& result) {
  if (result.settled()) return result.worn == drape::Worn::kNo ? kNotWorn : kDone;
  return result.stop_reason.kind == drape::Stop::kCancelled ? kCancelled : kUnsettled;
}

constexpr int kPageWidth = 440;  // pixels of a picture on the report's page

/// report.html, with those stills that were drawn.
Status write_page(const analysis::Report& report, const DrapeOptions& options) {
  const fs::path out = options.out;
  std::vector<exports::PagePicture> pictures;
  for (const char* view : {"front", "side", "back"}) {
    if (!options.stills) continue;
    const std::optional<std::string> bytes = read_file(out / (std::string(view) + ".png"));
    if (!bytes) continue;
    if (auto small = image::reduced_png(*bytes, kPageWidth)) pictures.push_back({view, std::move(*small)});
  }
  const json::JsonValue figures = TRY(json::parse_json(exports::report_json(report)));
  return write_file(out / "report.html", exports::report_page(figures, pictures));
}

/// Gives frames to the film and, where one is wanted, to a trace.
class Recorders final : public drape::FrameSink {
 public:
  explicit Recorders(proto::TraceWriter* trace) : trace_(trace) {}
  void begin(const sewing::GarmentMesh& garment) override {
    film_.begin(garment);
    if (trace_) trace_->begin(garment);
  }
  void frame(const drape::Frame& frame) override {
    film_.frame(frame);
    if (trace_) trace_->frame(frame);
  }
  const movie::Motion& motion() const { return film_.motion(); }

 private:
  movie::FilmRecorder film_;
  proto::TraceWriter* trace_;
};

/// Writes what a drape leaves and prints its figures.
Status deliver(const drape::DrapeInput& input, const drape::DrapeResult& result,
               const image::Textures& textures, const movie::Motion& motion, const DrapeOptions& options) {
  const analysis::Report report = analysis::make_report(input, result);
  TRY(jobs::write_models(input, result, textures, options.out, options.check_data));
  TRY(jobs::write_film(input, result, textures, motion, options.out));
  TRY(exports::write_report(fs::path(options.out) / "report.json", report));
  if (options.stills && exit_code_of(result) != kCancelled) {
    render::Stills stills;
    TRY(jobs::write_stills(stills, input, result, textures, options.out, options.width, options.height));
  }
  TRY(write_page(report, options));
  if (options.json) {
    std::printf("%s", exports::report_json(report).c_str());
  } else if (!options.quiet) {
    print_summary(report, options);
  }
  return {};
}

/// The trace that the options ask for; null where they ask for none.
Result<std::unique_ptr<proto::TraceWriter>> open_trace(const DrapeOptions& options) {
  if (options.trace.empty()) return std::unique_ptr<proto::TraceWriter>();
  return proto::TraceWriter::open(options.trace, options.trace_every);
}

/// `path` as seen from `folder`; empty where a manifest has no room for it.
std::string seen_from(const fs::path& folder, const fs::path& path) {
  std::error_code failure;
  const std::string relative = fs::proximate(path, folder, failure).generic_string();
  return failure || relative.size() > fields::kLongestText ? std::string() : relative;
}

Status deliver_manifest(manifest::Manifest manifest, const drape::DrapeResult& result,
                        const DrapeOptions& options) {
  const fs::path out = options.out;
  if (exit_code_of(result) == kCancelled) {  // nobody could drape to the moment of an interrupt again
    std::error_code ignored;
    fs::remove(out / manifest::kManifestFile, ignored);
    return {};
  }
  manifest.project_path = seen_from(out, options.project);
  if (!options.from.empty()) manifest.from_path = seen_from(out, shape_path(options.from));
  return jobs::write_manifest(std::move(manifest), result, out, options.check_data);
}

}  // namespace

ExitCode drape_command(const DrapeOptions& options) {
  Result<ReadyProject> ready = read_to_drape(options.project, options.from);
  if (!ready) return fail(ready.error(), options.json);
  std::vector<drape::Touch> touches;
  if (!options.replay.empty()) {
    auto read = read_touches(options.replay);
    if (!read) return fail(read.error(), options.json);
    touches = std::move(*read);
  }
  resolve::ResolvedProject& read = ready->read;
  if (const auto textures = resolve::read_textures(read); !textures)
    return fail(textures.error(), options.json);  // before the time of a drape is spent
  if (Status folder = make_results_folder(options.out); !folder) return fail(folder.error(), options.json);
  const Result<std::unique_ptr<proto::TraceWriter>> trace = open_trace(options);
  if (!trace) return fail(trace.error(), options.json);

  Recorders recorders(trace->get());
  const Result<drape::DrapeResult> result =
      drape_once(read.input, recorders, std::move(touches), options.threads);
  if (!result) return fail(result.error(), options.json);
  if (*trace) {
    if (Status traced = (*trace)->finish(); !traced) return fail(traced.error(), options.json);
  }
  if (result->positions.empty()) {
    print_error({"cancelled", "nothing was draped yet, and nothing is written", "", ErrorKind::kCancelled},
                options.json);
    return kCancelled;
  }
  const Result<image::Textures> textures = resolve::read_textures(read);  // of what was draped
  if (!textures) return fail(textures.error(), options.json);
  if (Status delivered = deliver(read.input, *result, *textures, recorders.motion(), options); !delivered)
    return fail(delivered.error(), options.json);
  if (Status marked = deliver_manifest(std::move(ready->manifest), *result, options); !marked)
    return fail(marked.error(), options.json);
  return exit_code_of(*result);
}

}  // namespace toile::app
