// Sources of a room are compiled in batches. A function without linkage whose name and arguments are those of
// one that a header of its namespace declares hides that one from the sources behind it in the batch, and
// nobody has to notice: they call the other one then.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace toile::rules {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The arguments' types, without their names and defaults: "(Vec2 in, Vec2 out)" as "Vec2,Vec2".
std::string types_of(const std::string& arguments) {
  static const std::regex spare(R"(\s*=.*$)"), name(R"(([\w>\]&*])\s+\w+$|([&*])\w+$)"), blank(R"(\s+)");
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : arguments) {
    depth += c == '<' || c == '(' ? 1 : c == '>' || c == ')' ? -1 : 0;
    if (c == ',' && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  std::string types;
  for (std::string part : parts) {
    part = std::regex_replace(part, blank, " ");
    part = std::regex_replace(part, std::regex(R"(^ | $)"), "");
    part = std::regex_replace(part, spare, "");
    part = std::regex_replace(part, name, "$1$2");
    types += (types.empty() ? "" : ",") + part;
  }
  return types;
}

/// "name(types)" of each function that begins at the left margin.
std::vector<std::string> functions_in(const std::string& text) {
  static const std::regex begins(
      R"((?:^|\n)(?!return|using|namespace|#)[\w:][\w:<>,&* ]*[ &*](\w+)\(([^()]*(?:\([^()]*\)[^()]*)*)\))");
  std::vector<std::string> functions;
  for (std::sregex_iterator at(text.begin(), text.end(), begins), end; at != end; ++at)
    functions.push_back((*at)[1].str() + "(" + types_of((*at)[2]) + ")");
  return functions;
}

/// What stands in the text's unnamed namespaces, but for those of one line, which hold a constant.
std::string without_linkage(const std::string& text) {
  static const std::string opens = "\nnamespace {\n", closes = "\n}  // namespace\n";
  std::string inside;
  for (std::size_t at = text.find(opens); at != std::string::npos; at = text.find(opens, at + 1)) {
    const bool one_line = text.compare(text.find('\n', at + opens.size()), 3, "\n}\n") == 0;
    if (!one_line) inside += text.substr(at, text.find(closes, at) - at);
  }
  return inside;
}

/// "folder: function: source" of each function that hides one of the headers beside it.
std::vector<std::string> hidden_in(const fs::path& root) {
  std::map<fs::path, std::map<std::string, std::string>> declared;
  std::vector<fs::path> sources;
  for (const char* top : {"core", "proto/cpp", "server"}) {
    if (!fs::exists(root / top)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
      const fs::path& file = entry.path();
      if (file.extension() == ".cpp") sources.push_back(file);
      if (file.extension() != ".h") continue;
      for (const std::string& function : functions_in(text_of(file)))
        declared[file.parent_path()].emplace(function, file.filename().string());
    }
  }
  std::vector<std::string> hidden;
  for (const fs::path& source : sources) {
    const std::map<std::string, std::string>& beside = declared[source.parent_path()];
    for (const std::string& function : functions_in(without_linkage(text_of(source))))
      if (const auto met = beside.find(function); met != beside.end())
        hidden.push_back(fs::relative(source, root).generic_string() + " hides " + function + " of " +
                         met->second);
  }
  return hidden;
}

TEST(FunctionNames, HideNoneOfTheHeadersBesideThem) {
  for (const std::string& one : hidden_in(TOILE_SOURCE_DIR)) ADD_FAILURE() << one;
}

TEST(FunctionNames, AreFoundWhereTheyHideOne) {
  const fs::path root = fs::path(testing::TempDir()) / "toile_rules_hidden";
  fs::remove_all(root);
  fs::create_directories(root / "core/mesh");
  fs::create_directories(root / "core/other");
  const auto write = [&](const char* file, const std::string& inside) {
    std::ofstream(root / file) << "namespace toile {\nnamespace {\n\n" + inside + "\n}  // namespace\n}\n";
  };
  std::ofstream(root / "core/mesh/a.h")
      << "namespace toile {\ndouble turn(Vec2 from, Vec2 to);\n"
         "bool met(const std::vector<Vec2>& points,\n         int most = 3);\n}\n";
  write("core/mesh/b.cpp",
        "double turn(double a, double b) { return a; }\ndouble other(Vec2 from, Vec2 to) {}");
  write("core/other/c.cpp", "double turn(Vec2 in, Vec2 out) { return 0; }");
  EXPECT_TRUE(hidden_in(root).empty());
  write("core/mesh/d.cpp", "double turn(Vec2 in, Vec2 out) {\n  return 0;\n}");
  write("core/mesh/e.cpp", "bool met(const std::vector<Vec2>& at, int limit) { return false; }");
  EXPECT_EQ(hidden_in(root).size(), 2u);
  fs::remove_all(root);
}

}  // namespace
}  // namespace toile::rules
