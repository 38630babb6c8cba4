#include "core/pattern/dxf/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/words.h"

namespace toile::dxf {
namespace {

struct Candidate {
  const char* name;
  double mm;
  int insunits;     // value of $INSUNITS
  double at_first;  // logarithm of likelihood before any evidence
};

// Metres and feet are believed only when the file states them.
constexpr std::array<Candidate, 5> kCandidates{
    {{"mm", 1, 4, 1}, {"cm", 10, 5, 0}, {"inch", 25.4, 1, 0}, {"m", 1000, 6, -6}, {"foot", 304.8, 2, -6}}};

/// Logarithms of likelihood, set by hand so that the dialects of the tests (test_units.cpp) and the drawings
/// of GarmentCode and FreeSewing, in millimetres and inches, come out in their unit: all of these do.
struct UnitWeights {
  double stated = 10;                          ///< the file says so
  double english = 4;                          ///< "ENGLISH": inches, mostly
  double measurement = 0.7;                    ///< $MEASUREMENT, which programs write without thought
  double metric_mm = 3, metric_cm = 2.2;       ///< "METRIC": both are written, millimetres more often
  double smallest = 300, largest = 2500;       ///< mm, of the largest piece of a garment …
  double decade_below = 5, decade_above = 12;  ///< … against each decade beyond; nobody wears 20 m, but a
                                               ///< collar may stand alone
  double narrowest = 150;  ///< mm, of the widest piece of three or more: bands are long, but something goes
                           ///< over the body …
  double decade_narrow = 10;  ///< … against each decade below
  double typical = 700;       ///< mm
  double off_typical = 0.25;  ///< times the squared logarithm of the size over it, …
  double off_most = 2;        ///< … which counts up to this: a gentle preference within what is possible
};
constexpr UnitWeights kWeights;

std::string figure(double v) { return std::abs(v) < 1000 ? significant_text(v, 4) : fixed_text(v, 0); }

/// A length as people say it: "13.6 m", "136 mm", "5.4 mm".
std::string length_words(double mm) {
  constexpr double kLong = 10000, kShort = 10;  // mm
  if (mm >= kLong) return fixed_text(mm / 1000, 1) + " m";
  return fixed_text(mm, mm < kShort ? 1 : 0) + " mm";
}

double likelihood_of_size(double mm) {
  const double off = std::log(mm / kWeights.typical);
  double score = -kWeights.off_typical * std::min(off * off, kWeights.off_most);
  if (mm < kWeights.smallest) score -= kWeights.decade_below * std::log10(kWeights.smallest / mm);
  if (mm > kWeights.largest) score -= kWeights.decade_above * std::log10(mm / kWeights.largest);
  return score;
}

/// What something in the file says of the unit: in words for the report, and as logarithms of likelihood.
struct Evidence {
  std::string words;
  std::vector<std::pair<std::string, double>> scores;  // of units, by name
};

std::vector<Evidence> header_evidence(const DxfFile& file) {
  std::vector<Evidence> all;
  if (!file.version.empty())
    all.push_back(
        {"$ACADVER is " + file.version + (file.insunits ? "" : "; the header states no unit ($INSUNITS)"),
         {}});
  if (file.insunits) {
    const std::string said =
        line_text(file.insunits->line) + ": $INSUNITS is " + figure(file.insunits->value) + ", ";
    const auto it = std::find_if(kCandidates.begin(), kCandidates.end(),
                                 [&](const Candidate& c) { return c.insunits == file.insunits->value; });
    Evidence& e = all.emplace_back();
    e.words = said + (it == kCandidates.end() ? "which states no unit" : it->name);
    if (it != kCandidates.end()) e.scores = {{it->name, kWeights.stated - it->at_first}};
  }
  if (file.measurement && (file.measurement->value == 0 || file.measurement->value == 1)) {
    const bool metric = file.measurement->value == 1;
    Evidence& e = all.emplace_back();
    e.words = line_text(file.measurement->line) + ": $MEASUREMENT is " + (metric ? "metric" : "imperial");
    if (metric) e.scores = {{"mm", kWeights.measurement}, {"cm", kWeights.measurement}};
    if (!metric) e.scores = {{"inch", kWeights.measurement}};
  }
  return all;
}

/// What a text means that says "Units: …".
Evidence meaning_of(const std::string& text) {
  const std::string words = lower_case(text);
  const auto says = [&](const char* word) { return words.find(word) != std::string::npos; };
  if (says("metric"))
    return {"mm in one system, cm in another", {{"mm", kWeights.metric_mm}, {"cm", kWeights.metric_cm}}};
  const bool inches = says("inch") || words == "in";
  if (says("english") || says("imperial") || inches)
    return {"inch", {{"inch", inches ? kWeights.stated : kWeights.english}}};
  if (says("millim") || words == "mm") return {"mm", {{"mm", kWeights.stated}}};
  if (says("centim") || words == "cm") return {"cm", {{"cm", kWeights.stated}}};
  return {"no unit known here", {}};
}

Evidence text_evidence(const DxfUnitText& text) {
  Evidence e = meaning_of(text.words);
  e.words = line_text(text.line) + ": a text says units are '" + text.words + "' (" + e.words + ")";
  return e;
}

double largest_of(const std::vector<Vec2>& sizes) {
  double largest = 0;
  for (const Vec2& size : sizes) largest = std::max({largest, size.x, size.y});
  return largest;
}

/// How wide the widest of the pieces is, across its longer side; 0 where they are too few to make a garment.
double widest_of(const std::vector<Vec2>& sizes) {
  constexpr std::size_t kGarment = 3;
  if (sizes.size() < kGarment) return 0;
  double widest = 0;
  for (const Vec2& size : sizes) widest = std::max(widest, std::min(size.x, size.y));
  return widest;
}

double likelihood_of_width(double mm) {
  if (mm <= 0 || mm > kWeights.narrowest) return 0;
  return -kWeights.decade_narrow * std::log10(kWeights.narrowest / mm);
}

/// Nothing when no piece has a size.
std::optional<Evidence> size_evidence(const std::vector<Vec2>& sizes) {
  const double largest = largest_of(sizes), widest = widest_of(sizes);
  if (!(largest > 0)) return std::nullopt;
  Evidence e;
  std::string as;
  for (std::size_t i = 0; i < kCandidates.size(); ++i) {
    const Candidate& c = kCandidates[i];
    e.scores.emplace_back(c.name, likelihood_of_size(largest * c.mm) + likelihood_of_width(widest * c.mm));
    if (i < 3) as += (i == 0 ? "" : ", ") + length_words(largest * c.mm) + " as " + c.name;
  }
  e.words = "the largest piece measures " + figure(largest) + " units: " + as;
  return e;
}

/// The unit with the highest sum; its confidence is its share of all likelihoods.
DxfUnit likeliest(const std::vector<Evidence>& all) {
  std::array<double, kCandidates.size()> scores{};
  for (std::size_t i = 0; i < scores.size(); ++i) scores[i] = kCandidates[i].at_first;
  std::vector<std::string> words;
  for (const Evidence& e : all) {
    for (const auto& [name, score] : e.scores)
      for (std::size_t i = 0; i < scores.size(); ++i)
        if (kCandidates[i].name == name) scores[i] += score;
    words.push_back(e.words);
  }
  const auto best = std::max_element(scores.begin(), scores.end());
  double sum = 0;
  for (const double s : scores) sum += std::exp(s - *best);
  const Candidate& c = kCandidates[std::size_t(best - scores.begin())];
  return {c.name, c.mm, 1 / sum, std::move(words), {}};
}

}  // namespace

DxfUnit decide_unit(const DxfFile& file, const std::vector<DxfUnitText>& texts,
                    const std::vector<Vec2>& sizes) {
  std::vector<Evidence> all = header_evidence(file);
  for (const DxfUnitText& text : texts) all.push_back(text_evidence(text));
  if (std::optional<Evidence> size = size_evidence(sizes)) all.push_back(*std::move(size));
  return likeliest(all);
}

DxfUnit given_unit(double mm_per_unit) {
  const auto it = std::find_if(kCandidates.begin(), kCandidates.end(),
                               [&](const Candidate& c) { return c.mm == mm_per_unit; });
  return {it == kCandidates.end() ? "other" : it->name, mm_per_unit, 1, {"asked for"}, {}};
}

std::optional<DxfUnitDoubt> doubt_of_given(const DxfUnit& given, const DxfUnit& own,
                                           const std::vector<Vec2>& sizes) {
  constexpr double kShortest = 30, kLongest = 5000;  // mm, of a garment's largest piece
  const double largest = largest_of(sizes), mm = largest * given.mm;
  if (own.mm == given.mm || largest == 0 || (mm > kShortest && mm < kLongest)) return {};
  return DxfUnitDoubt{own.name, mm, largest * own.mm};
}

std::string doubt_text(const DxfUnit& given) {
  const DxfUnitDoubt& doubt = *given.doubt;
  return "the largest piece is " + length_words(doubt.largest_mm) + " in the unit that was asked for (" +
         given.name + "); by itself the file would be taken to be in " + doubt.own +
         ", and that piece to be " + length_words(doubt.largest_own) + ": leave the unit out, or give " +
         doubt.own;
}

}  // namespace toile::dxf
