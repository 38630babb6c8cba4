#pragma once
// An entity of a DXF file while its groups come in.

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/pattern/dxf/entities.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {

/// Group code that is 1 for things on the printed sheet.
inline constexpr int kPaperSpace = 67;

/// What is read; all else is skipped.
enum class DxfType {
  kSkipped,
  kPolyline,
  kVertex,
  kSeqend,
  kLwPolyline,
  kLine,
  kArc,
  kCircle,
  kEllipse,
  kSpline,
  kPoint,
  kText,
  kMtext,
  kInsert,
  kAttribute,
  kBlock
};

DxfType dxf_type_of(std::string_view name);

/// Whether the numbers of this group code matter to an entity of this type.
bool wants(DxfType type, int code);

/// Whether an entity of this type is of no use when a number of it cannot be read.
bool needs_numbers(DxfType type);

/// An entity while its groups come in.
struct DxfDraft {
  DxfType type = DxfType::kSkipped;
  std::string name, layer = "0", text, reference;  // reference: group 2, a block's name
  bool has_layer = false;
  int line = 0;
  std::map<int, double> numbers;
  std::vector<DxfVertex> vertices;  // of LWPOLYLINE and SPLINE
  std::vector<DxfVertex> through;   // of SPLINE: points that it passes
  bool awaits_y = false, through_awaits_y = false;
  std::vector<double> knots, weights;
  std::optional<Error> fault;  // its first number that is none

  double number(int code, double otherwise = 0) const {
    const auto it = numbers.find(code);
    return it == numbers.end() ? otherwise : it->second;
  }
  int flags(int code = 70) const { return static_cast<int>(std::clamp(number(code), 0.0, 1e6)); }
  bool mirrored() const { return number(230, 1) < 0; }
  Vec2 at() const { return {number(10), number(20)}; }
};

/// The draft takes in what a group says of its layer, its words or the block that it names. Whether the group
/// was one of these.
bool take_words(DxfDraft& draft, const DxfGroup& group, DxfEncoding encoding);

/// Whether its points come in groups of its own, not as entities.
bool lists_points(const DxfDraft& draft);

/// Whether the number of this group is one more vertex or knot, of which a file may hold so many.
bool counts_as_vertex(const DxfDraft& draft, int code);

/// The draft takes in a number; its first that is none, or lies beyond `max_coordinate` (drawing units), is
/// its fault and counts as 0.
void take_number(DxfDraft& draft, const DxfGroup& group, double max_coordinate);

}  // namespace toile::dxf
