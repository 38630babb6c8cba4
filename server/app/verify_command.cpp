// Whether results are what their manifest says: the inputs, the files, and a second drape.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/hash.h"
#include "core/base/read_file.h"
#include "core/base/rounded.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/json/tree.h"
#include "core/manifest/manifest.h"
#include "core/manifest/touch_log.h"
#include "core/warm/hung_garment.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/drape_once.h"
#include "server/jobs/input.h"
#include "server/jobs/results.h"
#include "server/movie/film_recorder.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;
using manifest::Comparison;
using manifest::FileMark;

/// What a second drape gave.
struct SecondDrape {
  std::string positions;
  int steps = 0;
  Comparison results;
  std::optional<double> farthest;  ///< m, between a particle then and now; nothing where that cannot be told
};

struct Verdict {
  manifest::Manifest then;
  manifest::Maker now;
  Comparison inputs, results;  ///< on disk
  std::optional<SecondDrape> second;

  bool second_same() const {
    return !second ||
           (second->positions == then.positions && second->steps == then.steps && second->results.all_same());
  }
  bool same() const { return inputs.all_same() && results.changed.empty() && second_same(); }
};

Result<manifest::Manifest> read_manifest(const fs::path& path) {
  const std::optional<std::string> text = read_file(path);
  if (!text)
    return Error{"manifest.file",
                 "there is no manifest; results of toile drape and of jobs have one (not where they were "
                 "cancelled)",
                 path.string(), ErrorKind::kInput};
  Result<manifest::Manifest> read = manifest::parse_manifest(*text);
  if (!read) return json::error_at(path.string(), read.error());
  return read;
}

/// Where the document is: as told, or as the manifest remembers it.
Result<std::string> path_of(const std::string& told, const std::string& remembered, const fs::path& folder,
                            const char* option) {
  const fs::path path = told.empty() ? folder / remembered : fs::path(told);
  std::error_code ignored;
  if (fs::exists(path, ignored) && (!told.empty() || !remembered.empty())) return path.string();
  return Error{"manifest.input",
               std::string("what was draped is not where the manifest says; name it with ") + option,
               told.empty() ? remembered : told, ErrorKind::kInput};
}

/// The marks of those files that are in the folder.
std::vector<FileMark> marks_in(const fs::path& folder, const std::vector<FileMark>& wanted) {
  std::vector<FileMark> found;
  for (const FileMark& file : wanted) {
    // A manifest may come from anybody: only its own folder is looked into.
    if (fs::path(file.name).filename() != file.name) continue;
    if (const auto bytes = read_file(folder / file.name))
      found.push_back(manifest::mark_of(file.name, std::string_view(*bytes)));
  }
  return found;
}

bool names(const std::vector<FileMark>& files, const char* name) {
  return std::any_of(files.begin(), files.end(), [&](const FileMark& file) { return file.name == name; });
}

/// How far a particle hangs from where it hung, at most, m; nothing where the file of then is not here, or
/// the cloth has other particles.
std::optional<double> farthest(const fs::path& hung_file, const warm::HungGarment& now) {
  const std::optional<std::string> bytes = read_file(hung_file);
  if (!bytes) return std::nullopt;
  const Result<warm::HungGarment> then = warm::decode_hung(*bytes);
  if (!then || then->pieces.size() != now.pieces.size()) return std::nullopt;
  double most = 0;
  for (std::size_t i = 0; i < now.pieces.size(); ++i) {
    const std::vector<Vec3>&a = then->pieces[i].positions, &b = now.pieces[i].positions;
    if (a.size() != b.size()) return std::nullopt;
    for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, length(a[v] - b[v]));
  }
  return most;
}

Result<SecondDrape> drape_again(ReadyProject& ready, const Verdict& verdict, const fs::path& folder) {
  const image::Textures early = TRY(resolve::read_textures(ready.read));  // before the time is spent
  movie::FilmRecorder film;
  drape::DrapeInput& input = ready.read.input;
  std::vector<drape::Touch> touches;
  if (names(verdict.then.results, manifest::kTouchLogFile))
    touches = TRY(read_touches(folder / manifest::kTouchLogFile));
  const drape::DrapeResult result = TRY(drape_once(input, film, std::move(touches)));
  if (result.positions.empty() || result.stop_reason.kind == drape::Stop::kCancelled)
    return Error{"cancelled", "the second drape was not ended", "", ErrorKind::kCancelled};
  const image::Textures textures = TRY(resolve::read_textures(ready.read));  // of what was draped
  const auto scratch = TRY(jobs::TemporaryFolder::make(fs::temp_directory_path()));
  TRY(jobs::write_models(input, result, textures, scratch->path(), names(verdict.then.results, "sewn.json")));
  TRY(jobs::write_film(input, result, textures, film.motion(), scratch->path()));
  SecondDrape second;
  second.positions = hash_of(result.positions);
  second.steps = result.steps;
  second.results = manifest::compare(verdict.then.results, marks_in(scratch->path(), verdict.then.results));
  second.farthest = farthest(folder / jobs::kShapeFile, result.hung);
  return second;
}

Result<Verdict> verdict_on(const VerifyOptions& options) {
  fs::path path = options.source;
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) path /= manifest::kManifestFile;
  const fs::path folder = path.parent_path();
  Verdict verdict;
  verdict.then = TRY(read_manifest(path));
  verdict.results = manifest::compare(verdict.then.results, marks_in(folder, verdict.then.results));
  const std::string project = TRY(path_of(options.project, verdict.then.project_path, folder, "--project"));
  std::string from;
  if (names(verdict.then.inputs, jobs::kShapeFile))
    from = TRY(path_of(options.from, verdict.then.from_path, folder, "--from"));
  ReadyProject ready = TRY(read_to_drape(project, from));
  verdict.now = ready.manifest.made_by;
  std::vector<FileMark> then = verdict.then.inputs, now = ready.manifest.inputs;
  then.push_back(verdict.then.document);
  now.push_back(ready.manifest.document);
  verdict.inputs = manifest::compare(then, now);
  if (verdict.inputs.all_same() && !options.files_only)
    verdict.second = TRY(drape_again(ready, verdict, folder));
  return verdict;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

void print_files(const char* title, const Comparison& files, const char* same) {
  std::printf("  %-9s %zu %s", title, files.same.size(), same);
  const auto also = [](const std::vector<std::string>& some, const char* what) {
    if (!some.empty()) std::printf("; %s %s", listed(some).c_str(), what);
  };
  also(files.changed, "changed");
  also(files.missing, "not there");
  also(files.added, "new");
  std::printf("\n");
}

void print_verdict(const Verdict& verdict, const VerifyOptions& options) {
  std::printf("%s: %s\n", options.source.c_str(), verdict.same() ? "the same" : "not the same");
  print_files("inputs", verdict.inputs, "as they were");
  print_files("results", verdict.results, "as they were written");
  if (!verdict.second) {
    const char* why = options.files_only ? "not asked for" : "not tried: the inputs are others";
    std::printf("  %-9s %s\n", "drape", why);
    return;
  }
  const SecondDrape& second = *verdict.second;
  print_files("drape", second.results, "files again in the same bytes");
  std::printf("  %-9s %s after %d steps, then %s after %d\n", "positions", second.positions.c_str(),
              second.steps, verdict.then.positions.c_str(), verdict.then.steps);
  if (second.farthest && !verdict.second_same())
    std::printf("  %-9s %s mm at most between a particle then and now\n", "",
                fixed_text(mm_from_metres(*second.farthest), 4).c_str());
  if (verdict.then.made_by == verdict.now) return;
  std::printf("  %-9s then toile %s, engine %d; this is toile %s, engine %d%s\n", "program",
              verdict.then.made_by.version.c_str(), verdict.then.made_by.engine, verdict.now.version.c_str(),
              verdict.now.engine,
              verdict.then.made_by.engine == verdict.now.engine ? " in another build" : "");
}

json::JsonValue json_of(const std::vector<std::string>& names) {
  return std::vector<json::JsonValue>(names.begin(), names.end());
}

json::JsonValue json_of(const Comparison& files) {
  return std::vector<json::JsonMember>{{"same", json_of(files.same)},
                                       {"changed", json_of(files.changed)},
                                       {"missing", json_of(files.missing)},
                                       {"added", json_of(files.added)}};
}

std::string json_text(const Verdict& verdict) {
  std::vector<json::JsonMember> out{{"same", verdict.same()},
                                    {"same_program", verdict.then.made_by == verdict.now},
                                    {"inputs", json_of(verdict.inputs)},
                                    {"results", json_of(verdict.results)}};
  if (verdict.second) {
    std::vector<json::JsonMember> second{{"positions", verdict.second->positions},
                                         {"positions_then", verdict.then.positions},
                                         {"steps", static_cast<double>(verdict.second->steps)},
                                         {"steps_then", static_cast<double>(verdict.then.steps)},
                                         {"files", json_of(verdict.second->results)}};
    if (verdict.second->farthest)
      second.push_back({"farthest_mm", rounded(mm_from_metres(*verdict.second->farthest), 3)});
    out.push_back({"drape", std::move(second)});
  }
  return json::write_json(json::JsonValue(std::move(out)));
}

}  // namespace

ExitCode verify_command(const VerifyOptions& options) {
  const Result<Verdict> verdict = verdict_on(options);
  if (!verdict) return fail(verdict.error(), options.json);
  if (options.json) {
    std::printf("%s", json_text(*verdict).c_str());
  } else {
    print_verdict(*verdict, options);
  }
  return verdict->same() ? kDone : kNotSame;
}

}  // namespace toile::app
