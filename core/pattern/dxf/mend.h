#pragma once
// Groups whose codes are numbers, but not the ones that were written: a fault of one character.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/pattern/dxf/draft.h"
#include "core/pattern/dxf/groups.h"

namespace toile::dxf {

/// Looks at the groups of a drawing in their order, and tells what a code must have been where the format
/// leaves no other: names of records behind other codes than 0, an x whose y does not follow, a y without its
/// x, a second x where z belongs. What it changes it tells of.
class DxfMender {
 public:
  /// The group as it must have been written. `draft`: the entity whose groups come; null between entities.
  DxfGroup mended(const DxfGroup& group, const DxfDraft* draft);
  /// An x that stood under another code right before `group`, the y that the entity has no x for.
  std::optional<DxfGroup> lost_x(const DxfGroup& group, const DxfDraft* draft);
  /// The group has been taken.
  void taken(const DxfGroup& group);
  std::vector<DxfDamage> take_damages() { return std::exchange(damages_, {}); }

 private:
  std::optional<int> true_coordinate(const DxfGroup& group, const DxfDraft& draft) const;
  std::optional<int> true_code(const DxfGroup& group, const DxfDraft* draft) const;

  int last_code_ = -1, last_line_ = 0, mends_ = 0;
  std::string last_value_;
  std::vector<DxfDamage> damages_;
};

}  // namespace toile::dxf
