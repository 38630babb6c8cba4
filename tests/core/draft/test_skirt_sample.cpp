#include "core/draft/skirt_sample.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/write_file.h"
#include "core/body/mesh_import/load.h"
#include "core/pattern/dxf/read.h"

namespace toile {
namespace {

// Set TOILE_WRITE_SAMPLES to write the files of samples/skirt anew.
const std::filesystem::path kFolder = std::filesystem::path(TOILE_SOURCE_DIR) / "samples/skirt";

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string w; in >> w;) out.push_back(w);
  return out;
}

// Equal words, or numbers no farther apart than the tolerance.
void expect_alike(const std::string& name, const std::string& a, const std::string& b, double tolerance) {
  const std::vector<std::string> u = words(a), v = words(b);
  ASSERT_EQ(u.size(), v.size()) << name;
  for (size_t i = 0; i < u.size(); ++i) {
    if (u[i] == v[i]) continue;
    char *end_u = nullptr, *end_v = nullptr;
    const double x = std::strtod(u[i].c_str(), &end_u), y = std::strtod(v[i].c_str(), &end_v);
    ASSERT_TRUE(end_u != u[i].c_str() && std::string(end_u) == end_v)
        << name << ": " << u[i] << " and " << v[i];
    ASSERT_NEAR(x, y, tolerance) << name << ", word " << i;
  }
}

geometry::TriangleMesh shipped_body() { return mesh_import::load_mesh(kFolder / "body.obj").value(); }

TEST(SkirtSample, IsWhatTheCodeMakes) {
  const Result<std::vector<draft::SampleFile>> files = draft::make_skirt_sample(shipped_body());
  ASSERT_TRUE(files) << to_string(files.error());
  for (const draft::SampleFile& f : *files) {
    if (std::getenv("TOILE_WRITE_SAMPLES") != nullptr) {
      const Status written = write_file(kFolder / f.name, f.bytes);
      ASSERT_TRUE(written) << to_string(written.error());
    }
    std::ifstream in(kFolder / f.name, std::ios::binary);
    ASSERT_TRUE(in) << kFolder / f.name;
    std::stringstream shipped;
    shipped << in.rdbuf();
    expect_alike(f.name, shipped.str(), f.bytes, 1e-3);
  }
}

TEST(SkirtSample, GivesThePatternBackFromItsDxf) {
  const Result<std::vector<draft::SampleFile>> files = draft::make_skirt_sample(shipped_body());
  ASSERT_TRUE(files);
  const Result<dxf::DxfDrawing> drawing = dxf::read_dxf(files->front().bytes);
  ASSERT_TRUE(drawing) << to_string(drawing.error());
  ASSERT_EQ(drawing->pieces.size(), 4u);
  const char* names[] = {"front", "back", "band_front", "band_back"};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(drawing->pieces[i].name, names[i]);
    EXPECT_TRUE(drawing->pieces[i].holes.empty());
    ASSERT_TRUE(drawing->pieces[i].grain);
    EXPECT_NEAR(std::abs(drawing->pieces[i].grain->y), 1, 1e-9);
    const Result<pattern::Panel> panel = dxf::panel_from_piece(drawing->pieces[i]);
    ASSERT_TRUE(panel) << to_string(panel.error());
    EXPECT_EQ(panel->outline.edges.size(), 4u);
  }
}

}  // namespace
}  // namespace toile
