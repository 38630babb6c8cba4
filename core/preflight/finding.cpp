#include "core/preflight/finding.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"

namespace toile::preflight {

namespace {

/// Two pieces that get in each other's way are a pair; pieces of a ring or of one kind are a list.
bool is_of_pair(FindingKind kind) {
  return kind == FindingKind::kCrossesCloth || kind == FindingKind::kTouches || kind == FindingKind::kGap;
}

}  // namespace

const char* name_of(Concern::Thing thing) {
  switch (thing) {
    case Concern::Thing::kPiece:
      return "piece";
    case Concern::Thing::kEdge:
      return "edge";
    case Concern::Thing::kSeam:
      return "seam";
    case Concern::Thing::kBody:
      break;
  }
  return "body";
}

Concern piece_named(const std::string& id) { return {Concern::Thing::kPiece, id}; }
Concern edge_named(const std::string& id) { return {Concern::Thing::kEdge, id}; }
Concern seam_named(const std::string& id) { return {Concern::Thing::kSeam, id}; }
Concern body_named(const std::string& id) { return {Concern::Thing::kBody, id}; }

Finding found(FindingKind kind, std::string message, Concerns about, Vec3 place) {
  return {kind, traits_of(kind).usual, std::move(message), std::move(about), place, false};
}

std::string where_text(const Finding& finding) {
  std::string text;
  for (const Concern& c : finding.about) {
    if (c.thing == Concern::Thing::kBody) continue;
    if (!text.empty()) text += is_of_pair(finding.kind) ? " and " : ", ";
    text += std::string(name_of(c.thing)) + " " + c.id;
  }
  return text;
}

std::string place_text(Vec3 p) {
  return "at (" + fixed_text(p.x, 3) + ", " + fixed_text(p.y, 3) + ", " + fixed_text(p.z, 3) + ") m";
}

std::string length_text(double metres) {
  if (metres >= 1) return fixed_text(metres, 2) + " m";
  return fixed_text(1e3 * metres, metres < 0.1 ? 1 : 0) + " mm";
}

void sort_by_severity(Findings& findings) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
}

std::optional<Error> first_error(const Findings& findings) {
  for (const Finding& f : findings) {
    if (f.severity == Severity::kError) {
      return Error{std::string(code_of(f.kind)), f.message, where_text(f) + " " + place_text(f.place)};
    }
  }
  return std::nullopt;
}

}  // namespace toile::preflight
