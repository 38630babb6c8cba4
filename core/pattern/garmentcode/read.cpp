#include "core/pattern/garmentcode/read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/json/tree.h"
#include "core/pattern/curve.h"
#include "core/pattern/garmentcode/curves.h"
#include "core/pattern/garmentcode/trim.h"
#include "core/pattern/garmentcode/turns.h"
#include "core/pattern/garmentcode/values.h"
#include "core/pattern/validate.h"

namespace toile::garmentcode {
namespace {

constexpr double kFarthestMm = 1e5;  // as project documents allow
constexpr std::size_t kMostPanels = 1000;
constexpr std::size_t kMostEdges = 10000;  // of a panel
constexpr std::size_t kMostStitches = 1000;
constexpr double kLeastLengthMm = 1e-3;

/// What properties say about the file's figures.
struct Conventions {
  double mm = 10;  ///< per unit of the file
  bool relative = true;
};

Result<Conventions> conventions_of(const Place& root) {
  Conventions conventions;
  const Place properties = root.find("properties");
  if (properties.value == nullptr) return conventions;
  if (const Place units = properties.find("units_in_meter"); units.value != nullptr) {
    const double per_metre = TRY(number(units, "a number of units"));
    if (!(per_metre >= 1e-3 && per_metre <= 1e6))
      return Error{"garmentcode.unit", "units_in_meter must be between 0.001 and 1000000", units.pointer};
    conventions.mm = 1000 / per_metre;
  }
  if (const Place coords = properties.find("curvature_coords"); coords.value != nullptr) {
    const std::string* name = coords.value->text();
    if (name == nullptr || (*name != "relative" && *name != "absolute"))
      return Error{"garmentcode.type", "curvature_coords is \"relative\" or \"absolute\"", coords.pointer};
    conventions.relative = *name == "relative";
  }
  return conventions;
}

Result<Vec2> point_mm(const Place& place, const Conventions& conventions) {
  const auto xy = TRY(numbers<2>(place, "a point"));
  const Vec2 p{xy[0] * conventions.mm, xy[1] * conventions.mm};
  if (std::abs(p.x) <= kFarthestMm && std::abs(p.y) <= kFarthestMm) return p;
  return Error{"garmentcode.range", "the point is over a hundred metres away", place.pointer};
}

Result<Vec2> control_point(const Place& place, Vec2 a, Vec2 b, const Conventions& conventions) {
  if (!conventions.relative) return point_mm(place, conventions);
  const auto given = TRY(numbers<2>(place, "a control point"));
  const Vec2 p = relative_to_edge(a, b, {given[0], given[1]});
  if (std::abs(p.x) <= kFarthestMm && std::abs(p.y) <= kFarthestMm) return p;
  return Error{"garmentcode.range", "the control point is over a hundred metres away", place.pointer};
}

using Curves = std::vector<pattern::CubicBezier>;

/// Booleans are written as 0 and 1 or as false and true.
Result<bool> flag(const Place& place) {
  if (const bool* value = place.value->boolean()) return *value;
  const double value = TRY(number(place, "a flag"));
  return value != 0;
}

Result<Curves> arc(const Place& params, Vec2 a, Vec2 b, const Conventions& conventions) {
  TRY(list(params, "an arc's radius and two flags", 3, 3));
  const double radius = TRY(number(params.at(0), "a radius"));
  if (!(radius > 0 && radius * conventions.mm <= kFarthestMm))
    return Error{"garmentcode.range", "the radius is not within a hundred metres", params.at(0).pointer};
  const bool large = TRY(flag(params.at(1)));
  const bool left = TRY(flag(params.at(2)));
  return cubics_from_arc(a, b, radius * conventions.mm, large, left);
}

Result<Curves> bezier(const Place& params, std::size_t controls, Vec2 a, Vec2 b,
                      const Conventions& conventions) {
  TRY(list(params, "the list of control points", controls, controls));
  std::vector<Vec2> c;
  for (std::size_t i = 0; i < controls; ++i) {
    const Vec2 p = TRY(control_point(params.at(i), a, b, conventions));
    c.push_back(p);
  }
  return Curves{controls == 1 ? cubic_from_quadratic(a, c[0], b) : pattern::CubicBezier{a, c[0], c[1], b}};
}

Result<Curves> curves_of(const Place& edge, Vec2 a, Vec2 b, const Conventions& conventions) {
  const Place curvature = edge.find("curvature");
  if (curvature.value == nullptr) return Curves{pattern::line_segment(a, b)};
  if (curvature.value->array()) {
    const Vec2 c = TRY(control_point(curvature, a, b, conventions));
    return Curves{cubic_from_quadratic(a, c, b)};
  }
  TRY(object(curvature, "a curvature"));
  const Place type = curvature.find("type");
  const std::string* name = type.value == nullptr ? nullptr : type.value->text();
  if (name == nullptr) return wrong_type(type, "the curve's type");
  const Place params = curvature.find("params");
  if (*name == "quadratic") return bezier(params, 1, a, b, conventions);
  if (*name == "cubic") return bezier(params, 2, a, b, conventions);
  if (*name == "circle") return arc(params, a, b, conventions);
  return Error{"garmentcode.curve",
               "there is no curve " + in_quotes(*name) + " here; curves are quadratic, cubic or circle",
               type.pointer};
}

Result<std::vector<Vec2>> vertices_of(const Place& panel, const Conventions& conventions) {
  const Place given = TRY(list(panel.find("vertices"), "the list of vertices", 2, kMostEdges));
  std::vector<Vec2> vertices;
  for (std::size_t i = 0; i < given.value->array()->size(); ++i) {
    const Vec2 p = TRY(point_mm(given.at(i), conventions));
    vertices.push_back(p);
  }
  return vertices;
}

std::string label_of(const Place& place) {
  const json::JsonValue* label = place.value->find("label");
  return label != nullptr && label->text() ? *label->text() : "";
}

/// The edges as they stand in the file, mm.
Result<pattern::Loop> loop_of(const Place& panel, const Conventions& conventions,
                              std::vector<std::string>& labels) {
  const std::vector<Vec2> vertices = TRY(vertices_of(panel, conventions));
  const Place edges = TRY(list(panel.find("edges"), "the list of edges", 2, kMostEdges));
  pattern::Loop loop;
  std::optional<std::size_t> first, end;
  for (std::size_t i = 0; i < edges.value->array()->size(); ++i) {
    const Place edge = TRY(object(edges.at(i), "an edge"));
    const Place ends = edge.find("endpoints");
    TRY(list(ends, "an edge's two end points", 2, 2));
    const std::size_t from = TRY(index(ends.at(0), "vertex", vertices.size()));
    const std::size_t to = TRY(index(ends.at(1), "vertex", vertices.size()));
    if (end && *end != from)
      return Error{"garmentcode.open_outline", "the edge does not start where the one before it ends",
                   edge.pointer};
    const Vec2 a = vertices[from], b = vertices[to];
    if (length(b - a) < kLeastLengthMm)
      return Error{"garmentcode.edge_without_length", "the edge ends where it starts", edge.pointer};
    Curves curves = TRY(curves_of(edge, a, b, conventions));
    loop.edges.push_back({"e" + std::to_string(i), std::move(curves)});
    labels.push_back(label_of(edge));
    if (!first) first = from;
    end = to;
  }
  if (*end != *first)
    return Error{"garmentcode.open_outline", "the last edge does not end where the first starts",
                 edges.pointer};
  return loop;
}

void mirror_x(pattern::Loop& loop) {
  for (pattern::PanelEdge& edge : loop.edges)
    for (pattern::CubicBezier& c : edge.curves)
      for (Vec2* p : {&c.p0, &c.p1, &c.p2, &c.p3}) p->x = -p->x;
}

Result<GarmentCodePlace> placement_of(const Place& panel, const Conventions& conventions) {
  GarmentCodePlace rigid;
  if (const Place t = panel.find("translation"); t.value != nullptr) {
    const auto given = TRY(numbers<3>(t, "a translation"));
    const double m = metres_from_mm(conventions.mm);
    rigid.translation = {given[0] * m, given[1] * m, given[2] * m};
    if (!(length(rigid.translation) <= 100))
      return Error{"garmentcode.range", "the panel stands over a hundred metres away", t.pointer};
  }
  if (const Place r = panel.find("rotation"); r.value != nullptr) {
    const auto given = TRY(numbers<3>(r, "a rotation"));
    rigid.rotation = fixed_angles(given);
  }
  return rigid;
}

Status add_panel(const std::string& name, const Place& place, const Conventions& conventions,
                 GarmentCodeGarment& garment) {
  TRY(object(place, "a panel"));
  pattern::Panel panel;
  panel.id = name;
  GarmentCodePanel extra;
  pattern::Loop loop = TRY(loop_of(place, conventions, extra.edge_labels));
  const GarmentCodePlace placement = TRY(placement_of(place, conventions));
  extra.placement = placement;
  extra.label = label_of(place);
  panel.outline = std::move(loop);
  if (pattern::signed_area(panel.outline) < 0) {
    mirror_x(panel.outline);
    extra.placement.flipped = true;
  }
  if (const Status valid = pattern::validate(panel); !valid) {
    const std::vector<std::string> trimmed = trim_crossing_corners(panel);
    if (trimmed.empty() || !pattern::validate(panel)) return json::error_at(place.pointer, valid.error());
    for (const std::string& what : trimmed) garment.notes.push_back(place.pointer + ": " + what);
  }
  garment.pattern.panels.push_back(std::move(panel));
  garment.panels.push_back(std::move(extra));
  return {};
}

/// The names in panel_order, then the others in the file's order.
std::vector<std::string> order_of(const Place& pattern, const Place& panels) {
  std::vector<std::string> order;
  std::set<std::string> seen;
  const auto add = [&](const std::string& name) {
    if (panels.value->find(name) != nullptr && seen.insert(name).second) order.push_back(name);
  };
  if (const json::JsonValue* given = pattern.value->find("panel_order"); given != nullptr && given->array())
    for (const json::JsonValue& name : *given->array())
      if (name.text()) add(*name.text());
  for (const json::JsonMember& member : *panels.value->object()) add(member.key);
  return order;
}

Result<pattern::SeamEdge> seam_edge_of(const Place& side, const pattern::Pattern& pattern) {
  TRY(object(side, "a side of a stitch"));
  const Place name = side.find("panel");
  if (name.value == nullptr || !name.value->text()) return wrong_type(name, "a panel's name");
  const auto found = std::find_if(pattern.panels.begin(), pattern.panels.end(),
                                  [&](const pattern::Panel& p) { return p.id == *name.value->text(); });
  if (found == pattern.panels.end())
    return Error{"garmentcode.reference", "there is no panel " + in_quotes(*name.value->text()),
                 name.pointer};
  const std::size_t edge = TRY(index(side.find("edge"), "edge", found->outline.edges.size()));
  return pattern::SeamEdge{static_cast<Index>(found - pattern.panels.begin()), static_cast<Index>(edge),
                           false};
}

/// A stitch's third element, "right_wrong": the right side of one edge's cloth comes to lie beside the wrong
/// side of the other's, as where a lapel or collar is turned over. Its edges then run the same way.
Result<bool> joins_right_to_wrong(const Place& stitch) {
  if (stitch.value->array()->size() < 3) return false;
  const Place given = stitch.at(2);
  const std::string* flag = given.value->text();
  if (flag == nullptr) return wrong_type(given, "a stitch's flag");
  if (*flag == "right_wrong") return true;
  return Error{"garmentcode.stitch", "a stitch knows the flag \"right_wrong\", not " + in_quotes(*flag),
               given.pointer};
}

Status add_stitches(const Place& stitches, GarmentCodeGarment& garment) {
  if (stitches.value == nullptr) return {};
  TRY(list(stitches, "the list of stitches", 0, kMostStitches));
  std::set<std::pair<Index, Index>> sewn;
  for (std::size_t i = 0; i < stitches.value->array()->size(); ++i) {
    const Place stitch = stitches.at(i);
    TRY(list(stitch, "a stitch of two sides", 2, 3));
    const pattern::SeamEdge a = TRY(seam_edge_of(stitch.at(0), garment.pattern));
    const pattern::SeamEdge b = TRY(seam_edge_of(stitch.at(1), garment.pattern));
    const std::pair at_a{a.panel, a.edge}, at_b{b.panel, b.edge};
    if (sewn.contains(at_a) || sewn.contains(at_b) || at_a == at_b) {
      garment.notes.push_back(stitch.pointer + ": an edge of it is stitched already; left out");
      continue;
    }
    sewn.insert(at_a);
    sewn.insert(at_b);
    const bool right_on_wrong = TRY(joins_right_to_wrong(stitch));
    garment.pattern.seams.push_back({"seam" + std::to_string(i), {a}, {b}, right_on_wrong});
  }
  return {};
}

}  // namespace

Result<GarmentCodeGarment> read_garmentcode(std::string_view text) {
  const json::JsonValue json = TRY(json::parse_json(text));
  const Place root = TRY(object({&json, ""}, "a specification"));
  const Conventions conventions = TRY(conventions_of(root));
  const Place pattern = TRY(object(root.find("pattern"), "the pattern"));
  const Place panels = TRY(object(pattern.find("panels"), "the panels"));
  const std::size_t count = panels.value->object()->size();
  if (count == 0 || count > kMostPanels)
    return Error{"garmentcode.no_panels", "a specification has 1 to 1000 panels", panels.pointer};
  GarmentCodeGarment garment;
  for (const std::string& name : order_of(pattern, panels))
    TRY(add_panel(name, panels.find(name), conventions, garment));
  TRY(add_stitches(pattern.find("stitches"), garment));
  return garment;
}

}  // namespace toile::garmentcode
