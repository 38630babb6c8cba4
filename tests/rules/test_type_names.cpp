// Two different types of one name in one namespace break the one-definition rule: no compiler or linker has
// to notice, and the program then mixes up their members. All rooms share the namespace toile, so it is
// looked for here.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace toile::rules {
namespace {

namespace fs = std::filesystem;

/// "namespace::Name" of each class, struct and enum that a header defines (not only declares) at the left
/// margin.
std::vector<std::string> types_defined_in(std::istream& header) {
  static const std::regex opens(R"(^namespace ([\w:]*) ?\{)");
  static const std::regex defines(
      R"(^(?:struct|class|enum class|enum) (\w+)(?: final)?(?: : .*)?(?: \{.*)?$)");
  std::vector<std::string> names;
  std::string line, space;
  std::smatch found;
  while (std::getline(header, line)) {
    if (std::regex_search(line, found, opens)) {
      space = found[1];
    } else if (std::regex_search(line, found, defines)) {
      names.push_back(space + "::" + found[1].str());
    }
  }
  return names;
}

/// "name: header, header" of each type that several headers define.
std::vector<std::string> twins_in(const fs::path& root) {
  std::map<std::string, std::vector<std::string>> places;
  for (const char* top : {"core", "proto/cpp", "server"}) {
    if (!fs::exists(root / top)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
      if (entry.path().extension() != ".h") continue;
      std::ifstream in(entry.path());
      for (const std::string& name : types_defined_in(in)) {
        places[name].push_back(fs::relative(entry.path(), root).generic_string());
      }
    }
  }
  std::vector<std::string> twins;
  for (const auto& [name, headers] : places) {
    if (headers.size() < 2) continue;
    std::string twin = name + ":";
    for (const std::string& header : headers) twin += " " + header;
    twins.push_back(twin);
  }
  return twins;
}

TEST(TypeNames, StandForOneTypeEachInThisHouse) {
  for (const std::string& twin : twins_in(TOILE_SOURCE_DIR)) ADD_FAILURE() << twin;
}

TEST(TypeNames, AreFoundTwiceWhenTwoHeadersDefineThem) {
  const fs::path root = fs::path(testing::TempDir()) / "toile_rules_twins";
  fs::remove_all(root);
  fs::create_directories(root / "core/mesh");
  std::ofstream(root / "core/mesh/a.h") << "namespace toile {\nstruct Point {\n};\nstruct Other;\n}\n";
  std::ofstream(root / "core/mesh/b.h")
      << "namespace toile {\nstruct Point;\nclass Other final { int x; };\n}\n";
  std::ofstream(root / "core/mesh/c.h") << "namespace toile::deep {\nstruct Point {};\n}\n";
  EXPECT_TRUE(twins_in(root).empty());
  std::ofstream(root / "core/mesh/d.h") << "namespace toile {\nenum class Point {\n};\n}\n";
  EXPECT_EQ(twins_in(root).size(), 1u);
  fs::remove_all(root);
}

}  // namespace
}  // namespace toile::rules
