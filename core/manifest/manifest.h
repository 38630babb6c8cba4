#pragma once
// What a drape was made of and what came out, by hashes: whoever has the inputs can drape again and see that
// the bytes are the same. proto/schema/manifest.schema.json has each key.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "core/project/project.h"

namespace toile::manifest {

inline constexpr const char* kManifestFile = "manifest.json";

/// A file by its content.
struct FileMark {
  std::string name;
  double bytes = 0;
  std::string hash;  ///< 128-bit XXH3, 32 hex digits
  friend bool operator==(const FileMark&, const FileMark&) = default;
};

/// The mark of a file of these bytes.
FileMark mark_of(std::string name, std::string_view bytes);

/// The mark of a document: of its content as the program writes it, whatever blanks and order its file has.
FileMark mark_of(std::string name, const project::Project& project);

/// Which program draped.
struct Maker {
  std::string version;  ///< as toile --version tells it
  int engine = 0;       ///< rises when the engine's bytes change
  std::string program;  ///< hash of the program; empty where it could not be read
  friend bool operator==(const Maker&, const Maker&) = default;
};

/// This program, of that hash.
Maker this_program(std::string hash);

struct Manifest {
  int toile_manifest = 1;  ///< version of the format
  Maker made_by;
  /// Where the document stood, and the shape that the drape went on from, relative to the manifest; empty: in
  /// a store, nowhere, or at too long a path.
  std::string project_path, from_path;
  FileMark document;
  std::vector<FileMark> inputs;  ///< files that the document names and a shape to go on from, by name
  project::ProjectSettings settings;
  std::string positions;  ///< hash of the final positions, as in report.json
  int steps = 0;
  std::vector<FileMark> results;  ///< those whose bytes follow from the input alone, by name
};

std::string write_manifest(const Manifest& manifest);

/// Errors: manifest.damaged (no JSON, or not of this form), with the place in `where`.
Result<Manifest> parse_manifest(std::string_view text);

json::JsonValue manifest_schema();

/// How the files that were expected stand beside those that are there, by name.
struct Comparison {
  std::vector<std::string> same, changed, missing, added;
  bool all_same() const { return changed.empty() && missing.empty() && added.empty(); }
};
Comparison compare(const std::vector<FileMark>& expected, const std::vector<FileMark>& found);

}  // namespace toile::manifest
