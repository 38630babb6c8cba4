#include "core/pattern/seams/chains.h"

#include <algorithm>

#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

constexpr std::size_t kLongest = 8;  // runs on a side, if it is not a whole border

}  // namespace

std::vector<Chain> chains_of(const SeamModel& m, const std::vector<std::vector<Index>>& borders,
                             const std::vector<char>& locked) {
  std::vector<Chain> chains;
  for (std::size_t l = 0; l < borders.size(); ++l) {
    const std::size_t n = borders[l].size();
    for (std::size_t first = 0; first < n; ++first) {
      Chain chain{l, first, {}, 0, false};
      for (std::size_t k = 0; k < n; ++k) {
        const Index r = borders[l][(first + k) % n];
        if (m.runs[r].fold || (r < static_cast<Index>(locked.size()) && locked[r])) break;
        chain.runs.push_back(r);
        chain.length += m.runs[r].length;
        chain.whole = k + 1 == n;
        if (k < kLongest || chain.whole) chains.push_back(chain);
      }
    }
  }
  return chains;
}

bool overlap(const Chain& a, const Chain& b) {
  return a.border == b.border && std::any_of(a.runs.begin(), a.runs.end(), [&](Index r) {
           return std::find(b.runs.begin(), b.runs.end(), r) != b.runs.end();
         });
}

std::vector<double> corners_of(const SeamModel& m, const std::vector<Index>& runs) {
  std::vector<double> at;
  double s = 0;
  for (std::size_t k = 0; k + 1 < runs.size(); ++k) at.push_back(s += m.runs[runs[k]].length);
  return at;
}

double meeting_distance(double length_mm) {
  return std::max(kSeriesWeights.meet_least_mm, kSeriesWeights.meet * length_mm);
}

std::vector<double> seen_from(const SeamModel& m, const Chain& a, const Chain& b) {
  std::vector<double> at = corners_of(m, b.runs);
  std::reverse(at.begin(), at.end());
  for (double& s : at) s = (b.length - s) * a.length / b.length;
  return at;
}

}  // namespace toile::seams
