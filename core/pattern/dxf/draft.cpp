#include "core/pattern/dxf/draft.h"

#include <cmath>
#include <initializer_list>

namespace toile::dxf {
namespace {

constexpr double kMostBulge = 1e3;  // beyond, an arc is a full circle but for a thousandth

/// A spline lists its control points, the points that it passes, its knots and its weights.
bool is_spline(const DxfDraft& d) { return d.type == DxfType::kSpline; }

bool out_of_range(const DxfDraft& d, int code, double v, double max_coordinate) {
  if (code == 42 && d.type != DxfType::kInsert && d.type != DxfType::kEllipse)
    return std::abs(v) > kMostBulge;
  const bool length = code == 10 || code == 20 || code == 11 || code == 21 ||
                      (code == 40 && !is_spline(d) && d.type != DxfType::kEllipse);
  return length && std::abs(v) > max_coordinate;
}

/// One coordinate of a list of points: x begins a point, y ends it.
void take_coordinate(DxfDraft& d, std::vector<DxfVertex>& list, bool& awaits_y, bool is_x, int code,
                     double v) {
  if (is_x && awaits_y && !d.fault)
    d.fault = Error{"dxf.missing_coordinate",
                    "The " + d.name + " has no group " + std::to_string(code + 10) + ".", line_text(d.line)};
  if (is_x) list.push_back({{v, 0}, 0});
  if (!is_x && awaits_y) list.back().at.y = v;
  awaits_y = is_x;
}

/// Groups that repeat within one entity.
void take_listed(DxfDraft& d, int code, double v) {
  if (code == 10 || code == 20) {
    take_coordinate(d, d.vertices, d.awaits_y, code == 10, code, v);
  } else if (is_spline(d) && (code == 11 || code == 21)) {
    take_coordinate(d, d.through, d.through_awaits_y, code == 11, code, v);
  } else if (code == 42 && !d.vertices.empty()) {
    d.vertices.back().bulge = v;
  } else if (code == 40) {
    d.knots.push_back(v);
  } else if (code == 41) {
    d.weights.push_back(v);
  } else {
    d.numbers[code] = v;
  }
}

/// What is wrong with the number that the group should hold.
Error number_fault(const DxfDraft& d, const DxfGroup& group, bool is_none) {
  const std::string held = "Group " + std::to_string(group.code) + " of " + d.name + " holds ";
  const std::string value = clean_text(group.value.substr(0, 40)), where = line_text(group.line);
  if (is_none) return {"dxf.bad_number", held + "'" + value + "' where a finite number belongs.", where};
  return {"dxf.coordinate_range", held + value + ", which is beyond any pattern.", where};
}

}  // namespace

DxfType dxf_type_of(std::string_view name) {
  static const std::map<std::string_view, DxfType> kTypes{{"POLYLINE", DxfType::kPolyline},
                                                          {"VERTEX", DxfType::kVertex},
                                                          {"SEQEND", DxfType::kSeqend},
                                                          {"LINE", DxfType::kLine},
                                                          {"ARC", DxfType::kArc},
                                                          {"CIRCLE", DxfType::kCircle},
                                                          {"LWPOLYLINE", DxfType::kLwPolyline},
                                                          {"TEXT", DxfType::kText},
                                                          {"SPLINE", DxfType::kSpline},
                                                          {"ELLIPSE", DxfType::kEllipse},
                                                          {"POINT", DxfType::kPoint},
                                                          {"MTEXT", DxfType::kMtext},
                                                          {"ATTRIB", DxfType::kAttribute},
                                                          {"INSERT", DxfType::kInsert},
                                                          {"BLOCK", DxfType::kBlock}};
  const auto it = kTypes.find(name);
  return it == kTypes.end() ? DxfType::kSkipped : it->second;
}

bool wants(DxfType type, int code) {
  const auto any = [code](std::initializer_list<int> codes) {
    return code == kPaperSpace || std::find(codes.begin(), codes.end(), code) != codes.end();
  };
  switch (type) {
    case DxfType::kPolyline:
      return any({70, 230});
    case DxfType::kVertex:
      return any({10, 20, 42, 70});
    case DxfType::kLwPolyline:
      return any({10, 20, 42, 70, 90, 230});
    case DxfType::kLine:
      return any({10, 20, 11, 21});
    case DxfType::kArc:
      return any({10, 20, 40, 50, 51, 230});
    case DxfType::kCircle:
      return any({10, 20, 40, 230});
    case DxfType::kEllipse:
      return any({10, 20, 11, 21, 40, 41, 42, 230});
    case DxfType::kSpline:
      return any({10, 20, 11, 21, 40, 41, 70, 71, 72, 73});
    case DxfType::kPoint:
      return any({10, 20, 30, 50});
    case DxfType::kText:
    case DxfType::kMtext:
    case DxfType::kAttribute:
      return any({10, 20, 40});
    case DxfType::kInsert:
      return any({10, 20, 41, 42, 50, 66, 70, 71, 230});
    case DxfType::kBlock:
      return any({10, 20});
    default:
      return false;
  }
}

bool needs_numbers(DxfType type) {
  return type != DxfType::kText && type != DxfType::kMtext && type != DxfType::kAttribute &&
         type != DxfType::kBlock && type != DxfType::kSkipped;
}

bool take_words(DxfDraft& d, const DxfGroup& group, DxfEncoding encoding) {
  switch (group.code) {
    case 8:
      d.layer = clean_text(group.value, encoding);
      d.has_layer = true;
      return true;
    case 2:
      d.reference = clean_text(group.value, encoding);
      return true;
    case 1:
    case 3:  // long MTEXTs come in several groups 3 and a last group 1
      if (d.type == DxfType::kMtext)
        d.text = clean_text(d.text + clean_text(plain_text(group.value), encoding), {"UTF-8"});
      else if (group.code == 1)
        d.text = clean_text(group.value, encoding);
      else if (d.type == DxfType::kBlock && d.reference.empty())  // the block's name stands there once more
        d.reference = clean_text(group.value, encoding);
      return true;
    default:
      return false;
  }
}

bool lists_points(const DxfDraft& d) { return d.type == DxfType::kLwPolyline || is_spline(d); }

bool counts_as_vertex(const DxfDraft& d, int code) {
  return lists_points(d) && (code == 10 || (is_spline(d) && (code == 11 || code == 40)));
}

void take_number(DxfDraft& d, const DxfGroup& group, double max_coordinate) {
  const std::optional<double> v = number_of(group.value);
  const bool good = v && !out_of_range(d, group.code, *v, max_coordinate);
  if (!good && !d.fault) d.fault = number_fault(d, group, !v);
  const double value = good ? *v : 0;
  if (lists_points(d)) return take_listed(d, group.code, value);
  d.numbers[group.code] = value;
}

}  // namespace toile::dxf
