#include "core/pattern/seam_model.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/units.h"
#include "core/pattern/curve.h"

namespace toile {
namespace {

constexpr std::size_t kSamples = SeamRun::kSamples;

double degrees_between(Vec2 from, Vec2 to) {
  return degrees_from_radians(std::atan2(cross(from, to), dot(from, to)));
}

/// How far along a run its direction at the ends is measured, mm: past the rounding of a drawn corner.
double end_reach(double length) { return std::min(2.0, length / 4); }

void measure(const PanelEdge& edge, SeamRun& run) {
  const double whole = arc_length(edge);
  const double start = run.from * whole;
  run.length = (run.to - run.from) * whole;
  for (std::size_t i = 0; i < kSamples; ++i)
    run.at[i] = point_at_length(edge, start + run.length * static_cast<double>(i) / (kSamples - 1));
  double heading = 0;
  Vec2 before = run.at[1] - run.at[0];
  for (std::size_t i = 0; i + 1 < kSamples; ++i) {
    const Vec2 chord = run.at[i + 1] - run.at[i];
    heading += degrees_between(before, chord);
    run.turn[i] = heading;
    before = chord;
  }
}

/// Degrees that the cloth has between the end of one edge and the start of the next.
double corner_angle(const PanelEdge& before, const PanelEdge& after) {
  const double a = arc_length(before), b = arc_length(after);
  const Vec2 in = before.curves.back().p3 - point_at_length(before, a - end_reach(a));
  const Vec2 out = point_at_length(after, end_reach(b)) - after.curves.front().p0;
  return 180 - degrees_between(in, out);
}

/// Notches within 3 mm of the edge, as distances from its start.
std::vector<double> notches_on(const Panel& panel, const PanelEdge& edge) {
  constexpr double kNear = 3, kStep = 1;  // mm
  std::vector<double> found;
  const double whole = arc_length(edge);
  for (const Notch& notch : panel.notches) {
    double best = kNear, where = -1;
    const int steps = std::clamp(static_cast<int>(whole / kStep), 2, 2000);
    for (int i = 0; i <= steps; ++i) {
      const double s = whole * i / steps;
      const double d = length(point_at_length(edge, s) - notch.at);
      if (d < best) best = d, where = s;
    }
    if (where > kNear && where < whole - kNear) found.push_back(where);
  }
  std::sort(found.begin(), found.end());
  return found;
}

void add_panel(const Panel& panel, Index index, SeamModel& model) {
  const std::vector<PanelEdge>& edges = panel.outline.edges;
  const Index first = static_cast<Index>(model.runs.size());
  const std::size_t count = edges.size();
  for (std::size_t e = 0; e < count; ++e) {
    SeamRun run;
    run.panel = index, run.edge = static_cast<Index>(e);
    run.next = first + static_cast<Index>((e + 1) % count);
    measure(edges[e], run);
    run.angle = corner_angle(edges[(e + count - 1) % count], edges[e]);
    if (!panel.notches.empty()) run.notches = notches_on(panel, edges[e]);
    model.runs.push_back(std::move(run));
  }
}

bool alike(double a, double b) { return std::abs(a - b) <= 0.5 + 0.005 * std::max(a, b); }

/// Whether run i of a, turned over, is run j of b, with its corners.
bool mirrors(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  if (!alike(a.length, b.length) || std::abs(a.angle - m.runs[b.next].angle) > 2) return false;
  for (std::size_t k = 0; k + 1 < kSamples; ++k) {
    const double seen_back = b.turn[kSamples - 2] - b.turn[kSamples - 2 - k];
    if (std::abs(a.turn[k] - seen_back) > 4) return false;
  }
  return true;
}

std::vector<Index> runs_of(const SeamModel& m, Index panel) {
  std::vector<Index> runs;
  for (Index i = 0; i < static_cast<Index>(m.runs.size()); ++i)
    if (m.runs[i].panel == panel) runs.push_back(i);
  return runs;
}

/// The run of q that each run of p mirrors to, or nothing when q is not p turned over.
std::vector<Index> mirror_image(const SeamModel& m, Index p, Index q) {
  const std::vector<Index> a = runs_of(m, p), b = runs_of(m, q);
  const std::size_t n = a.size();
  if (n != b.size()) return {};
  for (std::size_t shift = 0; shift < n; ++shift) {
    std::vector<Index> image(n);
    bool all = true;
    for (std::size_t k = 0; k < n && all; ++k) {
      image[k] = b[(shift + n - k) % n];
      all = mirrors(m, a[k], image[k]);
    }
    if (all) return image;
  }
  return {};
}

void set_mirror(SeamModel& m, Index p, const std::vector<Index>& image) {
  const std::vector<Index> runs = runs_of(m, p);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    m.mirror[runs[k]] = image[k];
    m.mirror[image[k]] = runs[k];
  }
}

/// Pieces whose names say left and right go first, then any two, then those that mirror themselves.
void find_mirrors(SeamModel& m) {
  const Index count = static_cast<Index>(m.words.size());
  m.mirror.assign(m.runs.size(), kNone);
  std::vector<bool> taken(static_cast<std::size_t>(count), false);
  for (const bool named : {true, false}) {
    for (Index p = 0; p < count; ++p) {
      for (Index q = p + 1; q < count && !taken[p]; ++q) {
        const int sides = m.words[p].side * m.words[q].side;
        const bool faces = m.words[p].face * m.words[q].face < 0;
        if (taken[q] || faces || (named ? sides >= 0 : sides > 0)) continue;
        const std::vector<Index> image = mirror_image(m, p, q);
        if (image.empty()) continue;
        set_mirror(m, p, image);
        taken[p] = taken[q] = true;
      }
    }
  }
  for (Index p = 0; p < count; ++p) {
    if (taken[p]) continue;
    const std::vector<Index> image = mirror_image(m, p, p);
    if (!image.empty()) set_mirror(m, p, image);
  }
}

/// Lower-case words: a name falls apart at what is no letter and before capitals.
std::vector<std::string> split_words(const std::string& name) {
  std::vector<std::string> words(1);
  bool was_small = false;
  for (const char c : name) {
    const auto u = static_cast<unsigned char>(c);
    const bool letter = std::isalpha(u) != 0, capital = std::isupper(u) != 0;
    if (!letter || (capital && was_small)) words.emplace_back();
    if (letter) words.back().push_back(static_cast<char>(std::tolower(u)));
    was_small = letter && !capital;
  }
  return words;
}

}  // namespace

PieceWords words_of(const std::string& name) {
  PieceWords words;
  for (const std::string& w : split_words(name)) {
    const auto is = [&](std::initializer_list<const char*> any) {
      return std::any_of(any.begin(), any.end(), [&](const char* x) { return w == x; });
    };
    if (is({"left", "l", "lf", "lt", "lft"})) words.side = -1;
    if (is({"right", "r", "rt", "rgt", "rh"})) words.side = 1;
    if (is({"front", "f", "fr", "frt", "fnt", "ft", "cf"})) words.face = 1;
    if (is({"back", "b", "bk", "bck", "rear", "cb"})) words.face = -1;
    if (is({"sleeve", "slv", "sl", "cuff", "arm"})) words.limb = true;
  }
  return words;
}

SeamModel make_seam_model(const Pattern& pattern) {
  SeamModel model;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    add_panel(pattern.panels[p], static_cast<Index>(p), model);
    model.words.push_back(words_of(pattern.panels[p].id));
    model.up.push_back(normalized(pattern.panels[p].grain));
  }
  find_mirrors(model);
  return model;
}

SeamModel with_cuts(const Pattern& pattern, SeamModel model, Index r, const std::vector<double>& cuts) {
  const PanelEdge& edge = pattern.panels[model.runs[r].panel].outline.edges[model.runs[r].edge];
  const SeamRun whole = model.runs[r];
  if (model.mirror[r] != kNone) model.mirror[model.mirror[r]] = kNone;
  model.mirror[r] = kNone;
  const double per_mm = (whole.to - whole.from) / whole.length;
  Index at = r;
  for (const double cut : cuts) {
    const double f = whole.from + cut * per_mm;
    SeamRun rest = whole;
    rest.from = f, rest.angle = 180, rest.next = whole.next;
    model.runs[at].to = f;
    model.runs[at].next = static_cast<Index>(model.runs.size());
    measure(edge, model.runs[at]);
    measure(edge, rest);
    at = model.runs[at].next;
    model.runs.push_back(std::move(rest));
    model.mirror.push_back(kNone);
  }
  for (Index i = r; i != whole.next; i = model.runs[i].next) {
    SeamRun& part = model.runs[i];
    part.notches.clear();
    for (const double n : whole.notches) {
      const double s = n - (part.from - whole.from) / per_mm;
      if (s > 0 && s < part.length) part.notches.push_back(s);
    }
    if (part.next == r) break;  // the outline is this one run
  }
  return model;
}

}  // namespace toile
