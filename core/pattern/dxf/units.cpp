#include "core/pattern/dxf/units.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/pattern/dxf/groups.h"
#include "core/pattern/dxf/words.h"

namespace toile {
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
using Scores = std::array<double, kCandidates.size()>;

constexpr double kStated = 10, kEnglish = 4, kMeasurement = 0.7;
constexpr double kMetricMm = 3, kMetricCm = 2.2;        // both are written, millimetres more often
constexpr double kSmallest = 300, kLargest = 2500;      // mm, of the largest piece of a garment
constexpr double kPerDecadeBelow = 5, kPerDecade = 12;  // nobody wears 20 m, but a collar may stand alone
constexpr double kTypical = 700;                        // mm

std::string figure(double v) { return std::abs(v) < 1000 ? significant_text(v, 4) : fixed_text(v, 0); }

/// A length as people say it: "13.6 m", "136 mm", "5.4 mm".
std::string length_words(double mm) {
  constexpr double kLong = 10000, kShort = 10;  // mm
  if (mm >= kLong) return fixed_text(mm / 1000, 1) + " m";
  return fixed_text(mm, mm < kShort ? 1 : 0) + " mm";
}

double likelihood_of_size(double mm) {
  const double off = std::log(mm / kTypical);
  double score = -0.25 * std::min(off * off, 2.0);  // a gentle preference within what is possible
  if (mm < kSmallest) score -= kPerDecadeBelow * std::log10(kSmallest / mm);
  if (mm > kLargest) score -= kPerDecade * std::log10(mm / kLargest);
  return score;
}

class Judge {
 public:
  explicit Judge(const DxfFile& file) : file_(file) {
    for (std::size_t i = 0; i < kCandidates.size(); ++i) scores_[i] = kCandidates[i].at_first;
  }

  void hear_header() {
    if (!file_.version.empty())
      evidence_.push_back("$ACADVER is " + file_.version +
                          (file_.insunits ? "" : "; the header states no unit ($INSUNITS)"));
    if (file_.insunits) {
      const std::string said =
          line_text(file_.insunits->line) + ": $INSUNITS is " + figure(file_.insunits->value) + ", ";
      const auto it = std::find_if(kCandidates.begin(), kCandidates.end(),
                                   [&](const Candidate& c) { return c.insunits == file_.insunits->value; });
      evidence_.push_back(said + (it == kCandidates.end() ? "which states no unit" : it->name));
      if (it != kCandidates.end()) add(it->name, kStated - it->at_first);
    }
    if (file_.measurement && (file_.measurement->value == 0 || file_.measurement->value == 1)) {
      const bool metric = file_.measurement->value == 1;
      evidence_.push_back(line_text(file_.measurement->line) + ": $MEASUREMENT is " +
                          (metric ? "metric" : "imperial"));
      for (const char* name : {"mm", "cm"})
        if (metric) add(name, kMeasurement);
      if (!metric) add("inch", kMeasurement);
    }
  }

  void hear(const DxfUnitText& text) {
    const std::string words = lower_case(text.words);
    const auto says = [&](const char* word) { return words.find(word) != std::string::npos; };
    std::string meaning;
    if (says("metric")) {
      add("mm", kMetricMm);
      add("cm", kMetricCm);
      meaning = "mm in one system, cm in another";
    } else if (says("english") || says("imperial") || says("inch") || words == "in") {
      add("inch", says("inch") || words == "in" ? kStated : kEnglish);
      meaning = "inch";
    } else if (says("millim") || words == "mm") {
      add("mm", kStated);
      meaning = "mm";
    } else if (says("centim") || words == "cm") {
      add("cm", kStated);
      meaning = "cm";
    } else {
      meaning = "no unit known here";
    }
    evidence_.push_back(line_text(text.line) + ": a text says units are '" + text.words + "' (" + meaning +
                        ")");
  }

  void measure(const std::vector<double>& extents) {
    double largest = 0;
    for (const double e : extents) largest = std::max(largest, e);
    if (!(largest > 0)) return;
    std::string as;
    for (std::size_t i = 0; i < kCandidates.size(); ++i) {
      scores_[i] += likelihood_of_size(largest * kCandidates[i].mm);
      if (i < 3)
        as += (i == 0 ? "" : ", ") + length_words(largest * kCandidates[i].mm) + " as " + kCandidates[i].name;
    }
    evidence_.push_back("the largest piece measures " + figure(largest) + " units: " + as);
  }

  DxfUnit decide() {
    const auto best = std::max_element(scores_.begin(), scores_.end());
    double sum = 0;
    for (const double s : scores_) sum += std::exp(s - *best);
    const Candidate& c = kCandidates[std::size_t(best - scores_.begin())];
    return {c.name, c.mm, 1 / sum, std::move(evidence_)};
  }

 private:
  void add(const std::string& name, double score) {
    for (std::size_t i = 0; i < kCandidates.size(); ++i)
      if (kCandidates[i].name == name) scores_[i] += score;
  }

  const DxfFile& file_;
  Scores scores_{};
  std::vector<std::string> evidence_;
};

}  // namespace

DxfUnit decide_unit(const DxfFile& file, const std::vector<DxfUnitText>& texts,
                    const std::vector<double>& extents) {
  Judge judge(file);
  judge.hear_header();
  for (const DxfUnitText& text : texts) judge.hear(text);
  judge.measure(extents);
  return judge.decide();
}

DxfUnit given_unit(double mm_per_unit) {
  const auto it = std::find_if(kCandidates.begin(), kCandidates.end(),
                               [&](const Candidate& c) { return c.mm == mm_per_unit; });
  return {it == kCandidates.end() ? "other" : it->name, mm_per_unit, 1, {"asked for"}};
}

}  // namespace toile
