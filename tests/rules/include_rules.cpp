#include "tests/rules/include_rules.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
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
      {"material", {}},
      {"fabric", {"fields", "json", "material"}},
      {"pattern", {"geometry"}},
      {"dxf", {"geometry", "pattern"}},
      {"edit", {"geometry", "pattern"}},
      {"seams", {"geometry", "pattern"}},
      {"body", {"geometry"}},
      {"measure", {"geometry"}},
      {"mesh_import", {"geometry"}},
      {"collision", {"geometry"}},
      {"draft", {"dxf", "geometry", "measure", "pattern"}},
      {"mesh", {"geometry", "pattern"}},
      {"sewing", {"mesh"}},
      {"solver", {"collision", "material", "mesh", "sewing"}},
      {"render", {"body", "image", "mesh"}},
      {"mannequin", {"geometry", "measure"}},
      {"preflight", {"body", "collision", "geometry", "measure", "mesh", "pattern", "sewing"}},
      {"dressing", {"body", "collision", "geometry", "measure", "mesh", "sewing"}},
      {"arrange", {"body", "geometry", "measure", "mesh", "pattern", "preflight", "seams", "sewing"}},
      {"paper", {"geometry", "material", "mesh", "sewing"}},
      {"warm", {"collision", "dressing", "mesh", "pattern", "sewing"}},
      {"drape",
       {"arrange", "body", "collision", "dressing", "material", "mesh", "paper", "pattern", "preflight",
        "seams", "sewing", "solver", "warm"}},
      {"json", {}},
      {"fields", {"json"}},
      {"garmentcode", {"json", "pattern"}},
      {"project", {"fabric", "fields", "json", "mannequin", "measure", "pattern"}},
      {"resolve",
       {"arrange", "body", "drape", "dxf", "fabric", "image", "json", "mannequin", "material", "measure",
        "mesh_import", "pattern", "project", "sewing"}},
      {"create",
       {"drape", "dxf", "garmentcode", "geometry", "json", "measure", "pattern", "project", "seams",
        "sewing"}},
      {"print", {"pattern"}},
      {"manifest", {"drape", "fields", "json", "project"}},
      {"sweep", {"fabric", "json", "measure", "project"}},
      {"sample", {"create", "draft", "dxf", "pattern", "project"}},
      {"editing",
       {"create", "drape", "edit", "fabric", "fields", "json", "pattern", "project", "resolve", "sewing"}},
      {"proto", {"drape", "sewing"}},
      {"store", {}},
      {"sqlite", {"store"}},
      {"shares", {"store"}},
      {"accounts", {"store"}},
      {"log", {"json"}},
      {"analysis", {"body", "dressing", "drape", "geometry", "material", "measure", "preflight", "sewing"}},
      {"trials", {"collision", "drape", "fabric", "material", "mesh", "pattern", "sewing", "solver"}},
      {"exports", {"analysis", "drape", "fields", "geometry", "image", "json", "material", "mesh", "sewing"}},
      {"documents",
       {"arrange", "create",    "drape",   "dxf",   "editing",     "garmentcode", "geometry",  "image",
        "json",    "mannequin", "measure", "mesh",  "mesh_import", "pattern",     "preflight", "print",
        "project", "proto",     "resolve", "seams", "sewing",      "store",       "sweep",     "warm"}},
      {"movie",
       {"analysis", "body", "drape", "exports", "fabric", "geometry", "image", "proto", "render", "sewing"}},
      {"jobs",
       {"analysis", "documents", "drape", "exports", "geometry", "image", "json", "manifest", "mesh", "movie",
        "pattern", "project", "proto", "render", "resolve", "shares", "store", "sweep", "warm"}},
      {"ws", {"jobs", "json", "proto", "store"}},
      {"http", {"accounts", "jobs", "json", "shares", "store", "ws"}},
      {"webhooks", {"accounts", "http", "json", "store"}},
      {"handlers",
       {"accounts", "documents", "exports", "fabric", "http", "image", "jobs", "json", "print", "store",
        "sweep", "ws"}},
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
      {"assimp/", "assimp", {"core/body/mesh_import/load.", "core/exports/model_file."}, false},
      {"Eigen/",
       "Eigen",
       {"core/body/mannequin/broyden.", "core/dressing/shape_solver.", "core/pattern/fit_cubic.",
        "core/warm/flat_map."},
       false},
      {"GL/osmesa", "OSMesa", {"server/render/gl/context."}, false},
      {"GL/", "OpenGL", {"server/render/"}, true},
      {"nlohmann/",
       "nlohmann-json",
       {"core/json/tree.", "server/store/sqlite/rows.", "core/exports/write_glb.",
        "core/exports/write_report."},
       false},
      {"xxhash", "xxHash", {"core/base/hash."}, false},
      {"png", "libpng", {"core/image/"}, false},
      {"jpeglib", "libjpeg", {"core/image/"}, false},
      {"jerror", "libjpeg", {"core/image/"}, false},
      {"hpdf", "libharu", {"core/print/pdf."}, false},
      {"CLI/", "CLI11", {"server/app/"}, true},
      {"boost/", "Boost", {"server/http/", "server/ws/"}, true},
      {"sqlite3", "SQLite", {"server/store/sqlite/"}, false},
      {"zlib", "zlib", {"core/image/write_png.", "server/http/compress."}, false},
      {"spdlog/", "spdlog", {"server/log/"}, false},
      {"sodium", "libsodium", {"server/accounts/"}, false},
  };
  return all;
}

bool starts_with_any(std::string_view text, const Names& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](const std::string& prefix) { return text.starts_with(prefix); });
}

/// The folders within a room that are part of it, and no rooms of their own.
const Names& alcoves() {
  static const Names folders{"core/solver/constraints", "core/solver/lanes", "server/render/gl"};
  return folders;
}

/// "core/mesh/topology.h" → "mesh", "core/pattern/dxf/read.h" → "dxf", "proto/cpp/…" → "proto",
/// "server/app/…" → "app"; nothing for other folders.
std::optional<std::string> room_of(std::string_view path) {
  if (path.starts_with("proto/cpp/")) return "proto";
  if (!path.starts_with("core/") && !path.starts_with("server/")) return std::nullopt;
  fs::path folder = fs::path(path).parent_path();
  const Names& parts = alcoves();
  if (std::find(parts.begin(), parts.end(), folder.generic_string()) != parts.end())
    folder = folder.parent_path();
  if (!folder.has_parent_path()) return std::nullopt;
  return folder.filename().string();
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

/// Every header and source of the house.
std::vector<fs::path> sources_of(const fs::path& root) {
  std::vector<fs::path> files;
  for (const char* top : {"core", "proto/cpp", "server"}) {
    if (!fs::exists(root / top)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
      const fs::path extension = entry.path().extension();
      if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp"))
        files.push_back(entry.path());
    }
  }
  return files;
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

Violations unused_arrows(const fs::path& root) {
  std::set<std::pair<std::string, std::string>> used;
  Names paths;
  for (const fs::path& file : sources_of(root)) {
    const std::string path = fs::relative(file, root).generic_string();
    paths.push_back(path);
    for (const Include& include : includes_of(text_of(file))) {
      const auto from = room_of(path), to = include.angled ? std::nullopt : room_of(include.name);
      if (from && to) used.insert({*from, *to});
    }
  }
  Violations out;
  for (const auto& [room, others] : table()) {
    const bool lived_in =
        std::any_of(paths.begin(), paths.end(), [&](const auto& p) { return room_of(p) == room; });
    if (!lived_in) out.push_back(room + " is no room");
    for (const std::string& other : others)
      if (!used.contains({room, other})) out.push_back(room + " never includes " + other);
  }
  for (const Door& door : doors()) {
    for (const std::string& file : door.files) {
      const auto through = [&](const auto& p) {
        if (!p.starts_with(file)) return false;
        const std::vector<Include> includes = includes_of(text_of(root / p));
        return std::any_of(includes.begin(), includes.end(), [&](const Include& include) {
          return include.angled && include.name.starts_with(door.include);
        });
      };
      if (std::none_of(paths.begin(), paths.end(), through))
        out.push_back(std::string(door.library) + " never comes through " + file);
    }
  }
  return out;
}

Violations check_tree(const fs::path& root) {
  Violations out;
  for (const fs::path& file : sources_of(root)) {
    const std::string path = fs::relative(file, root).generic_string();
    const std::string text = text_of(file);
    const bool sibling = fs::exists(fs::path(file).replace_extension(".h"));
    const Violations here = check_file(path, text, sibling);
    out.insert(out.end(), here.begin(), here.end());
    for (const Include& include : includes_of(text)) {
      if (include.angled || fs::exists(root / include.name)) continue;
      out.push_back(path + ":" + std::to_string(include.line) + ": " + include.name + " is not there");
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace toile::rules
