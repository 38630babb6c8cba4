#include "core/pattern/dxf/collect.h"

#include <cmath>
#include <initializer_list>
#include <utility>

#include "core/pattern/dxf/groups.h"

namespace toile::dxf {
namespace {

Error too_large(const std::string& what, std::size_t limit, int line) {
  return {"dxf.too_large", "The drawing has more than " + std::to_string(limit) + " " + what + ", the limit.",
          line_text(line), ErrorKind::kTooLarge};
}

/// The groups without which the entity has no place.
std::initializer_list<int> needed_codes(DxfType type) {
  static const std::initializer_list<int> kPlace{10, 20}, kLine{10, 20, 11, 21}, kCircle{10, 20, 40},
      kArc{10, 20, 40, 50, 51}, kNone{};
  switch (type) {
    case DxfType::kVertex:
    case DxfType::kPoint:
      return kPlace;
    case DxfType::kLine:
    case DxfType::kEllipse:
      return kLine;
    case DxfType::kCircle:
      return kCircle;
    case DxfType::kArc:
      return kArc;
    default:
      return kNone;
  }
}

}  // namespace

bool DxfCurve::is_straight() const {
  if (kind != Kind::kPolyline) return false;
  for (const DxfVertex& v : vertices)
    if (v.bulge != 0) return false;
  return true;
}

std::optional<Error> DxfCollector::count_vertex(int line) {
  if (++vertices_ <= settings_.max_vertices) return std::nullopt;
  return too_large("vertices", settings_.max_vertices, line);
}

std::optional<Error> DxfCollector::count_entity(int line) {
  if (++entities_ <= settings_.max_entities) return std::nullopt;
  return too_large("entities", settings_.max_entities, line);
}

std::size_t DxfCollector::add(const DxfDraft& d) {
  return file_.log.add(d.name, d.layer, in_block_ ? file_.blocks.back().name : std::string(), d.line);
}

void DxfCollector::drop(const DxfDraft& d, const std::string& reason) {
  file_.log.mark(add(d), DxfFate::kDropped, reason);
}

void DxfCollector::fail(const DxfDraft& d, const Error& error) {
  drop(d, error.message);
  file_.log.warn(d.line, "the " + d.name + " is left out: " + error.message);
  if (!file_.fault) file_.fault = error;
}

std::optional<Error> DxfCollector::missing(const DxfDraft& d) const {
  const auto lacks = [&](int code) {
    return Error{"dxf.missing_coordinate", "The " + d.name + " has no group " + std::to_string(code) + ".",
                 line_text(d.line)};
  };
  if (d.awaits_y) return lacks(20);
  if (d.through_awaits_y) return lacks(21);
  for (const int code : needed_codes(d.type))
    if (!d.numbers.contains(code)) return lacks(code);
  return std::nullopt;
}

std::optional<Error> DxfCollector::store(DxfDraft& d) {
  if (d.type == DxfType::kBlock) return begin_block(d), std::nullopt;
  if (d.type == DxfType::kSeqend) return end_sequence(d), std::nullopt;
  std::optional<Error> fault = needs_numbers(d.type) ? d.fault : std::nullopt;
  if (!fault) fault = missing(d);
  if (d.type == DxfType::kVertex) {
    if (auto error = count_vertex(d.line)) return error;
    if (polyline_ && fault && !polyline_fault_) polyline_fault_ = fault;
    return add_vertex(d), std::nullopt;
  }
  if (auto error = count_entity(d.line)) return error;
  if (fault) return fail(d, *fault), std::nullopt;
  if (d.flags(kPaperSpace) == 1) return drop(d, "lies on the printed sheet (paper space)"), std::nullopt;
  switch (d.type) {
    case DxfType::kPolyline:
      begin_polyline(d);
      break;
    case DxfType::kLwPolyline:
      add_lwpolyline(d);
      break;
    case DxfType::kLine:
      add_line(d);
      break;
    case DxfType::kArc:
    case DxfType::kCircle:
      add_arc(d);
      break;
    case DxfType::kEllipse:
      add_ellipse(d);
      break;
    case DxfType::kSpline:
      add_spline(d);
      break;
    case DxfType::kPoint:
      add_point(d);
      break;
    case DxfType::kText:
    case DxfType::kMtext:
    case DxfType::kAttribute:
      add_text(d);
      break;
    case DxfType::kInsert:
      add_insert(d);
      break;
    default:
      drop(d, d.name + " makes no outline");
  }
  return std::nullopt;
}

void DxfCollector::begin_block(const DxfDraft& d) {
  in_block_ = true;
  file_.log.structure();
  file_.blocks.push_back({d.reference, d.fault ? Vec2{} : d.at(), d.line});
}

DxfCurve DxfCollector::curve_of(const DxfDraft& d) {
  DxfCurve c;
  c.layer = d.layer;
  c.line = d.line;
  c.mirrored = d.mirrored();
  c.entity = add(d);
  return c;
}

void DxfCollector::begin_polyline(const DxfDraft& d) {
  polyline_ = curve_of(d);
  polyline_->closed = (d.flags() & 1) != 0;
  polyline_->is_run = true;
  polyline_has_layer_ = d.has_layer;
  polyline_is_mesh_ = (d.flags() & (16 | 64)) != 0;
  polyline_fault_.reset();
}

void DxfCollector::add_vertex(const DxfDraft& d) {
  if (!polyline_) {
    drop(d, "a VERTEX outside of a POLYLINE");
    file_.log.warn(d.line, "VERTEX outside of a POLYLINE is left out");
    return;
  }
  file_.log.vertex();
  if (!polyline_has_layer_ && d.has_layer) {
    polyline_->layer = d.layer;
    polyline_has_layer_ = true;
  }
  const bool control_point = (d.flags() & 16) != 0;  // of a spline that the other vertices draw out
  if (polyline_is_mesh_ || polyline_fault_ || control_point) return;
  polyline_->vertices.push_back({d.at(), d.number(42)});
}

void DxfCollector::end_sequence(const DxfDraft& d) {
  if (!polyline_ && !attributes_follow_) {
    if (d.flags(kPaperSpace) != 1) drop(d, "a SEQEND without a POLYLINE");
    return;
  }
  file_.log.vertex();
  attributes_follow_ = false;
  end_polyline(0);
}

void DxfCollector::end_polyline(int line) {
  attributes_follow_ = attributes_follow_ && line == 0;
  if (!polyline_) return;
  DxfCurve curve = std::move(*polyline_);
  polyline_.reset();
  if (line > 0) file_.log.warn(curve.line, "POLYLINE without SEQEND: it ends before " + line_text(line));
  if (polyline_is_mesh_) return file_.log.mark(curve.entity, DxfFate::kDropped, "a mesh makes no outline");
  if (polyline_fault_) {
    file_.log.mark(curve.entity, DxfFate::kDropped, polyline_fault_->message);
    file_.log.warn(curve.line, "the POLYLINE is left out: " + polyline_fault_->message);
    if (!file_.fault) file_.fault = polyline_fault_;
    return;
  }
  if (curve.vertices.size() < 2)
    return file_.log.mark(curve.entity, DxfFate::kDropped, "it has fewer than two vertices");
  target().curves.push_back(std::move(curve));
}

void DxfCollector::cut_off(const DxfDraft& d) {
  if (d.type == DxfType::kBlock) return file_.log.structure();
  if (polyline_ && (d.type == DxfType::kVertex || d.type == DxfType::kSeqend)) {
    if (d.type == DxfType::kSeqend) return end_sequence(d);
    return file_.log.vertex();
  }
  drop(d, "the file ends within it");
  file_.log.warn(d.line, "the " + d.name + " is left out: the file ends within it");
}

bool DxfCollector::cut_polyline() {
  if (!polyline_) return false;
  file_.log.mark(polyline_->entity, DxfFate::kDropped, "the file ends within it");
  file_.log.warn(polyline_->line, "the POLYLINE is left out: the file ends within it");
  polyline_.reset();
  return true;
}

void DxfCollector::add_lwpolyline(DxfDraft& d) {
  if (d.vertices.size() < 2) return drop(d, "it has fewer than two vertices");
  DxfCurve c = curve_of(d);
  c.closed = (d.flags() & 1) != 0;
  c.is_run = true;
  c.vertices = std::move(d.vertices);
  target().curves.push_back(std::move(c));
}

void DxfCollector::add_line(const DxfDraft& d) {
  DxfCurve c = curve_of(d);
  c.vertices = {{d.at(), 0}, {{d.number(11), d.number(21)}, 0}};
  target().curves.push_back(std::move(c));
}

void DxfCollector::add_arc(const DxfDraft& d) {
  DxfCurve c = curve_of(d);
  c.kind = DxfCurve::Kind::kArc;
  c.vertices = {{d.at(), 0}};
  c.radius = std::abs(d.number(40));
  c.start = d.number(50);
  c.end = d.number(51);
  c.closed = d.type == DxfType::kCircle;
  target().curves.push_back(std::move(c));
}

void DxfCollector::add_ellipse(const DxfDraft& d) {
  constexpr double kWhole = 6.283185;  // radians, as far as files carry it
  DxfCurve c = curve_of(d);
  c.kind = DxfCurve::Kind::kEllipse;
  c.vertices = {{d.at(), 0}, {{d.number(11), d.number(21)}, 0}};
  c.radius = std::abs(d.number(40, 1));
  c.start = d.number(41);
  c.end = d.number(42, kWhole);
  c.closed = std::abs(c.end - c.start) >= kWhole - 1e-5;
  target().curves.push_back(std::move(c));
}

void DxfCollector::add_spline(DxfDraft& d) {
  const std::size_t n = d.vertices.size(), degree = std::size_t(d.flags(71));
  bool sound = degree >= 1 && degree <= 11 && n > degree && d.knots.size() == n + degree + 1 &&
               (d.weights.empty() || d.weights.size() == n);
  for (std::size_t i = 1; i < d.knots.size(); ++i) sound = sound && d.knots[i] >= d.knots[i - 1];
  for (const double w : d.weights) sound = sound && w > 0;
  if (!sound && d.through.size() < 2) {
    drop(d, "a SPLINE without usable knots and control points");
    file_.log.warn(d.line,
                   "SPLINE on layer " + d.layer + " has no usable knots and control points: left out");
    return;
  }
  DxfCurve c = curve_of(d);
  c.kind = sound ? DxfCurve::Kind::kSpline : DxfCurve::Kind::kThrough;
  c.degree = int(degree);
  c.closed = !sound && (d.flags() & 1) != 0;
  c.vertices = std::move(sound ? d.vertices : d.through);
  c.knots = std::move(d.knots);
  c.weights = std::move(d.weights);
  target().curves.push_back(std::move(c));
}

void DxfCollector::add_point(const DxfDraft& d) {
  DxfMark mark{d.layer, d.at(), std::abs(d.number(30)), {}, d.line, add(d)};
  if (d.numbers.contains(50)) mark.angle = d.number(50);
  target().marks.push_back(std::move(mark));
}

void DxfCollector::add_text(const DxfDraft& d) {
  if (d.text.empty()) return drop(d, "an empty text");
  target().texts.push_back({d.text, d.layer, d.fault ? Vec2{} : d.at(), d.number(40), d.line, add(d)});
}

void DxfCollector::add_insert(const DxfDraft& d) {
  attributes_follow_ = d.flags(66) == 1;
  if (d.number(70, 1) > 1 || d.number(71, 1) > 1)
    file_.log.warn(d.line, "INSERT of " + d.reference + " as an array: its first copy is read");
  target().inserts.push_back({d.reference,
                              d.layer,
                              d.at(),
                              {d.number(41, 1), d.number(42, 1)},
                              d.number(50),
                              d.mirrored(),
                              d.line,
                              add(d)});
}

}  // namespace toile::dxf
