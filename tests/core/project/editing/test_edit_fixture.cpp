// The edits of proto/fixtures/edits as the service does them. The page shows some of them by itself while the
// pointer moves, and asks for the others: web/test/editFixture.test.ts holds it to the same file.

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "core/json/tree.h"
#include "core/pattern/curve.h"
#include "core/project/editing/edits.h"
#include "core/project/resolve/resolve.h"

namespace toile {
namespace {

constexpr double kSame = 1e-9;        // mm, between control points
constexpr double kSameLength = 2e-6;  // mm: the file tells lengths to a millionth

const json::JsonValue& fixture() {
  static const json::JsonValue json = [] {
    std::ifstream in(std::string(TOILE_SOURCE_DIR) + "/proto/fixtures/edits/edits.json", std::ios::binary);
    return json::parse_json(std::string(std::istreambuf_iterator<char>(in), {})).value();
  }();
  return json;
}

const std::vector<json::JsonValue>& list_at(const json::JsonValue& object, std::string_view key) {
  return *object.find(key)->array();
}

const std::string& text_at(const json::JsonValue& object, std::string_view key) {
  return *object.find(key)->text();
}

/// A document whose one piece, "front", is this.
std::string document_of(const json::JsonValue& piece) {
  std::vector<json::JsonMember> members = *piece.object();
  members.push_back({"id", std::string("front")});
  members.push_back({"fabric", std::string("wool")});
  members.push_back({"placement", json::parse_json(R"({"rigid": {}})").value()});
  return R"({"toile": 1, "name": "Fixture", "seams": [], "bodies": [{"id": "ann", "file": "ann.obj"}],
    "fabrics": [{"id": "wool", "areal_mass_g_m2": 210, "stretch_warp_n_m": 1500, "stretch_weft_n_m": 900,
      "stretch_coupling_n_m": 200, "stretch_shear_n_m": 120, "bend_warp_un_m": 14.5, "bend_weft_un_m": 9,
      "bend_bias_un_m": 7, "thickness_mm": 0.6}], "pieces": [)" +
         json::write_json(json::JsonValue(std::move(members))) + "]}";
}

/// The pieces stand in the document, and an edit has no need of bodies.
resolve::ProjectFiles no_files() {
  return {.dxf_text = [](const std::string&) -> Result<std::string> {
            return Error{"test.file", "", ""};
          },
          .body_mesh = [](const std::string&,
                          const mesh_import::MeshSettings&) -> Result<mesh_import::RepairedMesh> {
            return Error{"test.body", "", ""};
          }};
}

using Edges = std::map<std::string, std::vector<pattern::CubicBezier>>;

Edges edges_of(project::Project project) {
  project.bodies.clear();
  const Result<drape::DrapeInput> input = resolve::resolve_project(project, no_files());
  EXPECT_TRUE(input) << to_string(input.error());
  Edges edges;
  if (!input) return edges;
  const pattern::Panel& panel = input->pattern.panels.front();
  for (const pattern::PanelEdge& edge : panel.outline.edges) edges[edge.id] = edge.curves;
  for (const pattern::Loop& hole : panel.holes) {
    for (const pattern::PanelEdge& edge : hole.edges) edges[edge.id] = edge.curves;
  }
  return edges;
}

Vec2 point_of(const json::JsonValue& pair) {
  return {*(*pair.array())[0].number(), *(*pair.array())[1].number()};
}

std::vector<pattern::CubicBezier> curves_of(const json::JsonValue& edge) {
  std::vector<pattern::CubicBezier> curves;
  if (edge.find("curves")) {
    for (const json::JsonValue& curve : list_at(edge, "curves")) {
      const std::vector<json::JsonValue>& points = *curve.array();
      curves.push_back({point_of(points[0]), point_of(points[1]), point_of(points[2]), point_of(points[3])});
    }
    return curves;
  }
  const std::vector<json::JsonValue>& points = list_at(edge, "points");
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    curves.push_back(pattern::line_segment(point_of(points[i]), point_of(points[i + 1])));
  }
  return curves;
}

/// What the edges are to be after a case, and how long those that changed.
struct Wanted {
  Edges edges;
  std::map<std::string, double> lengths;
};

Wanted wanted_of(const json::JsonValue& one, Edges before) {
  Wanted wanted{std::move(before), {}};
  for (const json::JsonValue& edge : list_at(one, "changed")) {
    wanted.edges[text_at(edge, "id")] = curves_of(edge);
    wanted.lengths[text_at(edge, "id")] = *edge.find("length_mm")->number();
  }
  if (const json::JsonValue* gone = one.find("gone")) {
    for (const json::JsonValue& id : *gone->array()) wanted.edges.erase(*id.text());
  }
  return wanted;
}

void expect_same(const std::vector<pattern::CubicBezier>& now,
                 const std::vector<pattern::CubicBezier>& wanted) {
  ASSERT_EQ(now.size(), wanted.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    const std::array have{now[i].p0, now[i].p1, now[i].p2, now[i].p3};
    const std::array want{wanted[i].p0, wanted[i].p1, wanted[i].p2, wanted[i].p3};
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(length(have[k] - want[k]), kSame) << "curve " << i << ", point " << k;
    }
  }
}

double length_of(const std::vector<pattern::CubicBezier>& curves) {
  double sum = 0;
  for (const pattern::CubicBezier& curve : curves) sum += pattern::arc_length(curve);
  return sum;
}

TEST(EditFixture, IsWhatTheServiceMakesOfEveryEdit) {
  ASSERT_GT(list_at(fixture(), "cases").size(), 10u);
  for (const json::JsonValue& one : list_at(fixture(), "cases")) {
    SCOPED_TRACE(text_at(one, "name"));
    const json::JsonValue& start = *fixture().find("starts")->find(text_at(one, "start"));
    const Result<project::Project> project = project::parse_project(document_of(start));
    ASSERT_TRUE(project) << to_string(project.error());
    const auto edits = editing::read_edits(*one.find("edits"), "/edits");
    ASSERT_TRUE(edits) << to_string(edits.error());
    const Result<editing::EditedProject> edited = editing::apply_edits(*project, *edits, no_files());
    ASSERT_TRUE(edited) << to_string(edited.error());
    const Wanted wanted = wanted_of(one, edges_of(*project));
    const Edges now = edges_of(edited->project);
    ASSERT_EQ(now.size(), wanted.edges.size());
    for (const auto& [id, curves] : wanted.edges) {
      SCOPED_TRACE(id);
      ASSERT_TRUE(now.contains(id));
      expect_same(now.at(id), curves);
      if (const auto told = wanted.lengths.find(id); told != wanted.lengths.end()) {
        EXPECT_NEAR(length_of(now.at(id)), told->second, kSameLength);
      }
    }
  }
}

}  // namespace
}  // namespace toile
