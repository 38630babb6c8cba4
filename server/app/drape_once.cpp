#include "server/app/drape_once.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "core/base/read_file.h"
#include "core/drape/pipeline.h"
#include "core/drape/worn_part.h"
#include "core/json/tree.h"
#include "core/manifest/touch_log.h"
#include "server/app/commands.h"
#include "server/app/engine_id.h"
#include "server/app/interrupt.h"
#include "server/app/mesh_reader.h"
#include "server/app/progress_bar.h"
#include "server/documents/used_files.h"
#include "server/jobs/input.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;
using manifest::FileMark;

/// How a garment hung, and the mark of its file.
Status read_before(const std::string& from, ReadyProject& ready) {
  const fs::path path = shape_path(from);
  const std::optional<std::string> bytes = read_file(path);
  if (!bytes) return Error{"usage.from", "cannot read how the garment hung", path.string()};
  Result<warm::HungGarment> hung = warm::decode_hung(*bytes);
  if (!hung) return Error{hung.error().code, hung.error().message, path.string(), hung.error().kind};
  ready.read.input.before = std::make_shared<const warm::HungGarment>(std::move(*hung));
  ready.manifest.inputs.push_back(manifest::mark_of(jobs::kShapeFile, std::string_view(*bytes)));
  return {};
}

/// Marks of the document and of the files that it names; those of pattern files are there already, from when
/// they were read. What cannot be read is told where it is used.
void mark_inputs(ReadyProject& ready, std::map<std::string, FileMark> marks) {
  const project::Project& project = ready.read.project;
  ready.manifest.document = manifest::mark_of("project.json", project);
  ready.manifest.settings = project.settings;
  for (const documents::UsedFile& file : documents::used_files(project)) {
    if (marks.contains(file.name)) continue;
    if (const auto bytes = read_file(ready.read.path.parent_path() / file.name))
      marks[file.name] = manifest::mark_of(file.name, std::string_view(*bytes));
  }
  for (auto& [name, mark] : marks) ready.manifest.inputs.push_back(std::move(mark));
}

}  // namespace

fs::path shape_path(const std::string& from) {
  std::error_code ignored;
  return fs::is_directory(from, ignored) ? fs::path(from) / jobs::kShapeFile : fs::path(from);
}

Result<ReadyProject> read_to_drape(const std::string& path, const std::string& from) {
  std::map<std::string, FileMark> patterns;
  const auto note = [&](const std::string& name, std::string_view bytes) {
    patterns[name] = manifest::mark_of(name, bytes);
  };
  ReadyProject ready{TRY(resolve::read_project(path, own_mesh_importer(), note)), {}};
  ready.manifest.made_by = manifest::this_program(engine_of_this_program());
  mark_inputs(ready, std::move(patterns));
  if (!from.empty()) TRY(read_before(from, ready));
  ready.read.input = drape::worn_part(std::move(ready.read.input));
  return ready;
}

Result<std::vector<drape::Touch>> read_touches(const fs::path& path) {
  const std::optional<std::string> text = read_file(path);
  if (!text) return Error{"usage.replay", "cannot read the log of hands on the cloth", path.string()};
  Result<std::vector<drape::Touch>> touches = manifest::parse_touch_log(*text);
  if (!touches) return json::error_at(path.string(), touches.error());
  return touches;
}

Result<drape::DrapeResult> drape_once(drape::DrapeInput& input, drape::FrameSink& sink,
                                      std::vector<drape::Touch> touches, int threads) {
  ProgressBar bar;
  RunContext context;
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  context.threads = std::clamp(threads > 0 ? threads : processors, 1, kMostThreads);
  context.cancel = &cancel_on_interrupt();
  context.on_progress = [&](const Progress& progress) { bar.show(progress); };
  Result<std::unique_ptr<drape::DrapeRun>> run = drape::DrapeRun::start(input, context, &sink);
  if (run) {
    if (const Status fits = (*run)->replay(std::move(touches)); !fits) run = fits.error();
  }
  if (run) (*run)->advance(std::numeric_limits<int>::max(), context);
  bar.clear();
  if (!run && run.error().kind == ErrorKind::kCancelled) return drape::DrapeResult{};
  if (!run) return run.error();
  drape::DrapeResult result = (*run)->conclude();
  if ((*run)->reduced()) input = drape::DrapeInput((*run)->input());
  return result;
}

}  // namespace toile::app
