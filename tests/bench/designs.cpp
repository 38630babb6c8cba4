#include "tests/bench/designs.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/project/create/create.h"
#include "core/project/resolve/resolve.h"

namespace toile::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSpecification = "_specification.json";

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::vector<fs::path> designs_of(const fs::path& data, bool even) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(data / "garmentcode/random")) {
    const std::string file = entry.path().filename().string();
    if (!file.ends_with(kSpecification)) continue;
    if ((std::atoi(file.substr(7, 4).c_str()) % 2 == 0) == even) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> garments_named(const fs::path& data, const std::string& argument) {
  if (argument == "even" || argument == "odd") return designs_of(data, argument == "even");
  if (argument.ends_with(".json")) return {argument};
  const bool number = !argument.empty() && std::isdigit(static_cast<unsigned char>(argument[0]));
  return {data / "garmentcode/random" / ((number ? "random_" + argument : argument) + kSpecification)};
}

std::string name_of_garment(const fs::path& file) {
  const std::string stem = file.stem().string();
  if (stem == "project") return file.parent_path().filename().string();
  return stem.substr(0, stem.find("_specification"));
}

Result<drape::DrapeInput> garment_input(const fs::path& file, const fs::path& body) {
  if (!file.string().ends_with(kSpecification))
    return std::move(TRY(resolve::read_project(file.string())).input);
  create::NewProjectSettings settings;
  settings.name = name_of_garment(file);
  settings.body_file = body.filename().string();
  auto made = TRY(create::new_project(text_of(file), settings));
  made.project.bodies[0].unit = "m";
  return resolve::resolve_project(made.project, resolve::files_in(body.parent_path(), {}));
}

}  // namespace toile::bench
