// A command reads the document and the pattern file once, whatever it makes of them.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/app/program.h"
#include "tests/open_counter.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// A folder with the sample in coarse triangles, of which nobody but the test knows.
fs::path coarse_sample(const std::string& name) {
  const fs::path folder = fresh_folder(name);
  fs::copy(fs::path(TOILE_SOURCE_DIR) / "samples" / "skirt", folder, fs::copy_options::recursive);
  std::string document = text_of(folder / "project.json");
  const std::string fine = "\"particle_distance_mm\": 16.20";
  EXPECT_NE(document.find(fine), std::string::npos);
  document.replace(document.find(fine), fine.size(), "\"particle_distance_mm\": 60");
  write_text(folder / "project.json", document);
  return folder;
}

void expect_read_once(const std::string& name, const fs::path& folder,
                      const std::vector<std::string>& arguments) {
  test::OpenCounter document(folder / "project.json"), pattern(folder / "skirt.dxf");
  const Ran ran = run_toile(arguments);
  EXPECT_TRUE(ran.code == 0 || ran.code == 3) << name << ": " << ran.err;  // 3: drape found no rest
  EXPECT_EQ(document.opened(), 1) << name << " reads the document";
  EXPECT_EQ(pattern.opened(), 1) << name << " reads the pattern";
}

TEST(Commands, ReadADocumentAndItsPatternOnce) {
  const fs::path folder = coarse_sample("reads");
  const std::string project = (folder / "project.json").string();
  const fs::path out = fresh_folder("reads_out");
  expect_read_once("check", folder, {"check", project});
  expect_read_once("drape", folder, {"drape", project, "--no-stills", "--out", (out / "drape").string()});
  expect_read_once("pattern export", folder,
                   {"pattern", "export", project, "--out", (out / "a.dxf").string()});
  expect_read_once("project arrange", folder,
                   {"project", "arrange", project, "--out", (out / "project.json").string()});
}

}  // namespace
}  // namespace toile
