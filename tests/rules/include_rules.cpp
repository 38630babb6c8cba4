#include "tests/rules/include_rules.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>

namespace toile::rules {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

/// Room → rooms that it may include directly. `base` is open to all.
const std::map<std::string, Names>& table() {
  static const std::map<std::string, Names> rooms{
      {"base", {}},
      {"geometry", {}},
      {"image", {}},
      {"pattern", {"geometry"}},
      {"material", {}},
      {"body", {"geometry"}},
      {"collision", {"geometry"}},
      {"draft", {"pattern", "body", "geometry"}},
      {"mesh", {"pattern", "geometry"}},
      {"sewing", {"mesh", "pattern", "body", "collision", "geometry"}},
      {"preflight", {"sewing", "mesh", "pattern", "body", "collision", "geometry"}},
      {"arrange", {"preflight", "sewing", "mesh", "pattern", "body", "collision", "geometry"}},
      {"solver", {"sewing", "mesh", "material", "collision", "geometry"}},
      {"drape",
       {"preflight", "solver", "sewing", "mesh", "pattern", "material", "body", "collision", "geometry"}},
      {"analysis",
       {"drape", "solver", "sewing", "mesh", "pattern", "material", "body", "collision", "geometry"}},
      {"export", {"drape", "image", "mesh", "pattern", "material", "analysis"}},
      {"proto", {"analysis", "arrange", "drape", "image", "sewing", "mesh", "pattern", "material", "body"}},
      {"store", {"proto"}},
      {"auth", {"store"}},
      {"render", {"drape", "image", "mesh", "body", "pattern", "material", "analysis"}},
      {"documents",
       {"store", "proto", "arrange", "drape", "image", "preflight", "sewing", "mesh", "pattern", "body",
        "draft"}},
      {"jobs", {"documents", "store", "proto", "render", "export", "image", "analysis", "drape"}},
      {"ws", {"jobs", "store", "proto", "auth"}},
      {"http", {"ws", "jobs", "documents", "auth", "store", "proto"}},
  };
  return rooms;
}

/// A library and the only files (path prefixes) that may include it.
struct Door {
  const char* include;  ///< prefix of what stands between the brackets
  const char* library;
  Names files;
  bool in_headers;  ///< whether a header behind the door may show it
};

const std::vector<Door>& doors() {
  static const std::vector<Door> all{
      {"assimp/", "assimp", {"core/body/load_mesh."}, false},
      {"GL/osmesa", "OSMesa", {"server/render/gl_context."}, false},
      {"EGL/", "EGL", {"server/render/gl_context."}, false},
      {"GL/", "OpenGL", {"server/render/"}, true},
      {"nlohmann/",
       "nlohmann-json",
       {"proto/cpp/", "server/app/config.", "core/pattern/garmentcode_read.", "core/export/write_glb.",
        "core/export/write_report."},
       false},
      {"Eigen/",
       "Eigen",
       {"core/pattern/", "core/solver/", "core/analysis/", "core/body/", "core/mesh/"},
       false},
      {"xxhash", "xxHash", {"core/base/hash."}, false},
      {"png", "libpng", {"core/image/"}, false},
      {"jpeglib", "libjpeg", {"core/image/"}, false},
      {"jerror", "libjpeg", {"core/image/"}, false},
      {"CLI/", "CLI11", {"server/app/"}, true},
      {"boost/", "Boost", {"server/http/", "server/ws/"}, true},
      {"sqlite3", "SQLite", {"server/store/"}, false},
      {"pqxx", "libpqxx", {"server/store/"}, false},
  };
  return all;
}

bool starts_with_any(std::string_view text, const Names& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](const std::string& prefix) { return text.starts_with(prefix); });
}

/// "core/mesh/topology.h" → "mesh", "proto/cpp/…" → "proto", "server/app/…" → "app"; nothing for other
/// folders.
std::optional<std::string> room_of(std::string_view path) {
  if (path.starts_with("proto/cpp/")) return "proto";
  for (const std::string_view top : {"core/", "server/"}) {
    if (!path.starts_with(top)) continue;
    const std::string_view rest = path.substr(top.size());
    const std::size_t slash = rest.find('/');
    if (slash != std::string_view::npos) return std::string(rest.substr(0, slash));
  }
  return std::nullopt;
}

struct Include {
  std::string name;
  bool angled = false;
  int line = 0;
};

std::vector<Include> includes_of(std::string_view text) {
  std::vector<Include> found;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
    if (!line.starts_with("#include")) continue;
    const std::size_t open = line.find_first_of("\"<");
    const std::size_t close = open == std::string::npos ? open : line.find_first_of("\">", open + 1);
    if (close == std::string::npos) continue;
    found.push_back({line.substr(open + 1, close - open - 1), line[open] == '<', number});
  }
  return found;
}

/// Why `path` may not include a library's header, or nothing.
std::optional<std::string> library_fault(std::string_view path, const Include& include) {
  for (const Door& door : doors()) {
    if (!include.name.starts_with(door.include)) continue;
    if (!starts_with_any(path, door.files)) return std::string(door.library) + " has its door elsewhere";
    if (path.ends_with(".h") && !door.in_headers) return std::string(door.library) + " stays out of headers";
    return std::nullopt;
  }
  return std::nullopt;
}

/// Why a file of `room` may not include one of the project's own headers, or nothing.
std::optional<std::string> room_fault(const std::string& room, const Include& include) {
  const std::optional<std::string> other = room_of(include.name);
  if (!other) return "not from the repo root, or no room of the house";
  if (*other == room || *other == "base" || room == "app") return std::nullopt;
  const Names& open = table().at(room);
  if (std::find(open.begin(), open.end(), *other) != open.end()) return std::nullopt;
  return room + " may not include " + *other;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

Violations check_file(const std::string& path, std::string_view text, bool sibling_header) {
  const std::optional<std::string> room = room_of(path);
  if (!room || (*room != "app" && !table().contains(*room))) return {path + ":0: not in a room of the house"};
  Violations out;
  const std::vector<Include> includes = includes_of(text);
  for (const Include& include : includes) {
    const auto fault = include.angled ? library_fault(path, include) : room_fault(*room, include);
    if (fault) out.push_back(path + ":" + std::to_string(include.line) + ": " + include.name + ": " + *fault);
  }
  if (sibling_header && path.ends_with(".cpp")) {
    const std::string own = path.substr(0, path.size() - 4) + ".h";
    if (includes.empty() || includes.front().name != own)
      out.push_back(path + ":1: its own header comes first");
  }
  return out;
}

Violations check_tree(const fs::path& root) {
  Violations out;
  for (const char* top : {"core", "proto/cpp", "server"}) {
    if (!fs::exists(root / top)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
      const fs::path extension = entry.path().extension();
      if (!entry.is_regular_file() || (extension != ".h" && extension != ".cpp")) continue;
      const std::string path = fs::relative(entry.path(), root).generic_string();
      const std::string text = text_of(entry.path());
      const bool sibling = fs::exists(fs::path(entry.path()).replace_extension(".h"));
      const Violations here = check_file(path, text, sibling);
      out.insert(out.end(), here.begin(), here.end());
      for (const Include& include : includes_of(text)) {
        if (include.angled || fs::exists(root / include.name)) continue;
        out.push_back(path + ":" + std::to_string(include.line) + ": " + include.name + " is not there");
      }
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace toile::rules
