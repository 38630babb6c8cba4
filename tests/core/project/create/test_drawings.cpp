// Garments as offices draw them: a change of the rules for seams shows where it changes them
// (tests/data/drawings/README.md).

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "core/project/create/create.h"

namespace toile {
namespace {

namespace fs = std::filesystem;
const fs::path kDrawings = fs::path(TOILE_SOURCE_DIR) / "tests/data/drawings";

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string side_text(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& side) {
  std::set<std::string> edges;
  for (const pattern::SeamEdge& e : side)
    edges.insert(pattern.panels[e.panel].id + "." + edges_of(pattern.panels[e.panel])[e.edge]->id);
  std::string text;
  for (const std::string& edge : edges) text += (text.empty() ? "" : " + ") + edge;
  return text;
}

/// The seams that a new project takes, a line each: "e01: Back.e0 -- Back_mirrored.e0".
std::set<std::string> seams_taken(const fs::path& drawing) {
  create::NewProjectSettings settings;
  settings.name = drawing.stem().string();
  settings.pattern_file = drawing.filename().string();
  settings.body_file = "body.obj";
  settings.accept_seams = create::kSure;
  const Result<create::NewProject> made = create::new_project(text_of(drawing), settings);
  EXPECT_TRUE(made.ok()) << drawing << ": " << (made.ok() ? "" : to_string(made.error()));
  std::set<std::string> lines;
  if (!made) return lines;
  for (const pattern::Seam& seam : made->pattern.seams) {
    const std::string a = side_text(made->pattern, seam.a), b = side_text(made->pattern, seam.b);
    lines.insert(settings.name + ": " + std::min(a, b) + " -- " + std::max(a, b));
  }
  return lines;
}

TEST(LongDrawings, AreSewnAsTheyWere) {
  std::vector<fs::path> drawings;
  for (const fs::directory_entry& entry : fs::directory_iterator(kDrawings))
    if (entry.path().extension() == ".dxf") drawings.push_back(entry.path());
  std::sort(drawings.begin(), drawings.end());
  ASSERT_EQ(drawings.size(), 132U);
  std::set<std::string> now, before;
  for (const fs::path& drawing : drawings) now.merge(seams_taken(drawing));
  const fs::path kept = kDrawings / "seams.txt";
  const char* write = std::getenv("TOILE_WRITE_SEAMS");
  if (write != nullptr && std::string(write) == "1") {
    std::ofstream out(kept, std::ios::trunc);
    for (const std::string& line : now) out << line << "\n";
    ASSERT_TRUE(out.flush()) << "cannot write " << kept;
    return;
  }
  std::ifstream in(kept);
  for (std::string line; std::getline(in, line);) before.insert(line);
  for (const std::string& line : before)
    if (!now.contains(line)) ADD_FAILURE() << "no longer sewn: " << line;
  for (const std::string& line : now)
    if (!before.contains(line)) ADD_FAILURE() << "newly sewn: " << line;
}

}  // namespace
}  // namespace toile
