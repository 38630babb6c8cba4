#pragma once
// The keys of drape.log, for its reader, its writer and its schema.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/json/fields/range.h"
#include "core/json/fields/schema.h"

namespace toile::manifest {

/// drape::Touch in the form of its JSON.
struct LoggedTouch {
  int step = 0;
  std::string touch = "pull";
  int id = 0;
  std::optional<int> triangle;
  std::optional<std::array<double, 3>> shares;
  std::optional<Vec3> to;
};

struct TouchLog {
  int toile_drape_log = 1;  ///< version of the format
  std::vector<LoggedTouch> touches;
};

}  // namespace toile::manifest

namespace toile::fields {

inline constexpr Range kShare{0, 1};
inline constexpr Range kWholeNumber{0, 2147483647};
inline constexpr Range kTouchTarget{-100, 100};

template <typename Visitor>
void describe(Visitor& v, manifest::LoggedTouch& touch) {
  v.object("touch", "What a hand did.");
  v.field("step", touch.step, "Substeps that the drape had made; never fewer than before.", Need::kRequired,
          kWholeNumber);
  v.choice("touch", touch.touch,
           "pull: a hand takes hold of a point, or draws what it holds elsewhere; let_go: it opens; pin: a "
           "point stays where it is; unpin: it does not any more.",
           {"pull", "let_go", "pin", "unpin"}, Need::kRequired);
  v.field("id", touch.id, "Which hand, or which pin (1, 2, … in the order in which they were set).",
          Need::kRequired);
  v.field(
      "triangle", touch.triangle,
      "Index of the triangle that was taken hold of, as the stream's topology has them; where a hand draws "
      "on it is absent.",
      Need::kOptional, kWholeNumber);
  v.field("shares", touch.shares, "Where on it: shares of its corners, whose sum is 1.", Need::kOptional,
          kShare);
  v.field("to", touch.to, "m; where a hand pulls to.", Need::kOptional, kTouchTarget);
}

template <typename Visitor>
void describe(Visitor& v, manifest::TouchLog& log) {
  v.object("", "Hands that were on cloth while it draped. toile verify lets them do it again.");
  v.field("toile_drape_log", log.toile_drape_log, "Version of this format.", Need::kRequired, Range{1, 1});
  v.field("touches", log.touches, "In their order.", Need::kRequired, Range{0, 100000});
}

}  // namespace toile::fields
