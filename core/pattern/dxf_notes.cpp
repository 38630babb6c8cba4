#include "core/pattern/dxf_notes.h"

#include <algorithm>
#include <utility>

#include "core/pattern/dxf_groups.h"

namespace toile {
namespace {
constexpr std::size_t kMostNotes = 500;
}

void DxfNotes::add(int line, std::string text) {
  if (notes_.size() < kMostNotes) notes_.push_back({line, std::move(text)});
}

void DxfNotes::count(int line, const std::string& kind) {
  if (tallies_.size() >= kMostNotes && !tallies_.contains(kind)) return;
  Tally& tally = tallies_[kind];
  if (tally.count++ == 0) tally.line = line;
}

std::vector<std::string> DxfNotes::told() const {
  std::vector<Note> all = notes_;
  for (const auto& [kind, tally] : tallies_)
    all.push_back({tally.line, std::to_string(tally.count) + " " + kind});
  std::stable_sort(all.begin(), all.end(), [](const Note& a, const Note& b) { return a.line < b.line; });
  std::vector<std::string> lines;
  for (const Note& n : all) lines.push_back(line_text(n.line) + ": " + n.text);
  return lines;
}

}  // namespace toile
