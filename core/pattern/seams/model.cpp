#include "core/pattern/seams/model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/pattern/curve.h"

namespace toile::seams {
namespace {

constexpr std::size_t kSamples = SeamRun::kSamples;

double degrees_between(Vec2 from, Vec2 to) {
  return degrees_from_radians(std::atan2(cross(from, to), dot(from, to)));
}

/// How far along a run its direction at the ends is measured, mm: past the rounding of a drawn corner.
double end_reach(double length) { return std::min(2.0, length / 4); }

void measure(const pattern::PanelEdge& edge, SeamRun& run) {
  const double whole = pattern::arc_length(edge);
  const double start = run.from * whole;
  run.length = (run.to - run.from) * whole;
  for (std::size_t i = 0; i < kSamples; ++i)
    run.at[i] = pattern::point_at_length(edge, start + run.length * static_cast<double>(i) / (kSamples - 1));
  const Vec2 chord = run.at[kSamples - 1] - run.at[0];
  run.straight = true;
  for (const Vec2 p : run.at)
    run.straight = run.straight && std::abs(cross(chord, p - run.at[0])) <= 0.002 * run.length * run.length;
  double heading = 0;
  Vec2 before = run.at[1] - run.at[0];
  for (std::size_t i = 0; i + 1 < kSamples; ++i) {
    const Vec2 step = run.at[i + 1] - run.at[i];
    heading += degrees_between(before, step);
    run.turn[i] = heading;
    before = step;
  }
}

/// Degrees that the cloth has between the end of one edge and the start of the next.
double corner_angle(const pattern::PanelEdge& before, const pattern::PanelEdge& after) {
  const double a = pattern::arc_length(before), b = pattern::arc_length(after);
  const Vec2 in = before.curves.back().p3 - pattern::point_at_length(before, a - end_reach(a));
  const Vec2 out = pattern::point_at_length(after, end_reach(b)) - after.curves.front().p0;
  return 180 - degrees_between(in, out);
}

/// Notches within 3 mm of the edge, as distances from its start.
std::vector<double> notches_on(const pattern::Panel& panel, const pattern::PanelEdge& edge) {
  constexpr double kNear = 3, kStep = 1;  // mm
  std::vector<double> found;
  const double whole = pattern::arc_length(edge);
  for (const pattern::Notch& notch : panel.notches) {
    double best = kNear, where = -1;
    const int steps = std::clamp(static_cast<int>(whole / kStep), 2, 2000);
    for (int i = 0; i <= steps; ++i) {
      const double s = whole * i / steps;
      const double d = length(pattern::point_at_length(edge, s) - notch.at);
      if (d < best) {
        best = d;
        where = s;
      }
    }
    if (where > kNear && where < whole - kNear) found.push_back(where);
  }
  std::sort(found.begin(), found.end());
  return found;
}

void add_panel(const pattern::Panel& panel, Index index, SeamModel& model) {
  const std::vector<pattern::PanelEdge>& edges = panel.outline.edges;
  const Index first = static_cast<Index>(model.runs.size());
  const std::size_t count = edges.size();
  for (std::size_t e = 0; e < count; ++e) {
    SeamRun run;
    run.panel = index;
    run.edge = static_cast<Index>(e);
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
    SeamRun &a = m.runs[runs[k]], &b = m.runs[image[k]];
    a.mirror_panel = b.panel;
    a.mirror_edge = b.edge;
    b.mirror_panel = a.panel;
    b.mirror_edge = a.edge;
  }
  const Index q = m.runs[image[0]].panel;
  m.twin[p] = q;
  m.twin[q] = p;
}

/// Pieces whose names say left and right go first, then any two, then those that mirror themselves.
void find_mirrors(SeamModel& m) {
  const Index count = static_cast<Index>(m.words.size());
  m.twin.assign(m.words.size(), kNone);
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

/// The run that mirrors each, as the edges do.
void match_mirrors(SeamModel& m) {
  constexpr double kSame = 0.01;  // of the edge
  const auto count = static_cast<Index>(m.runs.size());
  m.mirror.assign(m.runs.size(), kNone);
  for (Index i = 0; i < count; ++i) {
    const SeamRun& a = m.runs[i];
    for (Index j = i; j < count && a.mirror_panel != kNone && m.mirror[i] == kNone; ++j) {
      const SeamRun& b = m.runs[j];
      if (b.panel != a.mirror_panel || b.edge != a.mirror_edge) continue;
      if (std::abs(a.from - (1 - b.to)) > kSame || std::abs(a.to - (1 - b.from)) > kSame) continue;
      m.mirror[i] = j;
      m.mirror[j] = i;
    }
  }
}

bool near(double a, double b) { return std::abs(a - b) <= 0.03 * std::max(a, b); }

/// Pairs up the runs of two pieces of which most of the outline agrees in length, as drawn or one of them
/// turned over.
void find_counterparts(SeamModel& m, Index p, Index q) {
  constexpr double kMost = 0.7;  // of the outline
  const std::vector<Index> a = runs_of(m, p), b = runs_of(m, q);
  const std::size_t n = a.size();
  if (n != b.size()) return;
  for (std::size_t way = 0; way < 2 * n; ++way) {
    const auto other = [&](std::size_t k) { return b[(way < n ? way + k : way - n + (n - k)) % n]; };
    double agreeing = 0;
    for (std::size_t k = 0; k < n; ++k)
      if (near(m.runs[a[k]].length, m.runs[other(k)].length)) agreeing += m.runs[a[k]].length;
    if (agreeing < kMost * m.girth[p]) continue;
    for (std::size_t k = 0; k < n; ++k) {
      m.counterparts[a[k]].push_back(other(k));
      m.counterparts[other(k)].push_back(a[k]);
    }
  }
}

/// Whether run i of a is run j of b, with its corners.
bool is_same(const SeamModel& m, Index i, Index j) {
  const SeamRun &a = m.runs[i], &b = m.runs[j];
  if (!alike(a.length, b.length) || std::abs(a.angle - b.angle) > 2) return false;
  for (std::size_t k = 0; k + 1 < kSamples; ++k)
    if (std::abs(a.turn[k] - b.turn[k]) > 4) return false;
  return true;
}

/// Pairs up the runs of two pieces of one form.
void find_same(SeamModel& m, Index p, Index q) {
  const std::vector<Index> a = runs_of(m, p), b = runs_of(m, q);
  const std::size_t n = a.size();
  if (n != b.size()) return;
  for (std::size_t shift = 0; shift < n; ++shift) {
    bool all = true;
    for (std::size_t k = 0; k < n && all; ++k) all = is_same(m, a[k], b[(k + shift) % n]);
    if (!all) continue;
    for (std::size_t k = 0; k < n; ++k) {
      m.same[a[k]].push_back(b[(k + shift) % n]);
      m.same[b[(k + shift) % n]].push_back(a[k]);
    }
  }
}

bool is_part_word(const std::string& w) {
  static const char* const kParts[] = {"torso", "bodice", "body", "panel", "skirt",
                                       "pant",  "leg",    "yoke", "sleeve"};
  return std::any_of(std::begin(kParts), std::end(kParts), [&](const char* part) { return w == part; });
}

}  // namespace

PieceWords words_of(const std::string& name) {
  PieceWords words;
  for (const std::string& w : words_of_name(name)) {
    const auto is = [&](std::initializer_list<const char*> any) {
      return std::any_of(any.begin(), any.end(), [&](const char* x) { return w == x; });
    };
    // "backpanel", "ftorso": written as one
    const auto starts = [&](const char* start, char letter) {
      return w.starts_with(start) || (w[0] == letter && is_part_word(w.substr(1)));
    };
    if (is({"l", "lf", "lt", "lft"}) || starts("left", 'l')) words.side = -1;
    if (is({"r", "rt", "rgt", "rh"}) || starts("right", 'r')) words.side = 1;
    if (is({"f", "fr", "frt", "fnt", "ft", "cf"}) || starts("front", 'f')) words.face = 1;
    if (is({"b", "bk", "bck", "rear", "cb"}) || starts("back", 'b')) words.face = -1;
    if (is({"lining", "facing", "interfacing", "interlining", "fusing", "canvas", "pocket", "welt", "bag",
            "flap"}))
      words.layer = true;
    if (is({"slv", "sl", "arm"}) || w.ends_with("sleeve") || w.ends_with("cuff")) words.limb = true;
  }
  return words;
}

SeamModel make_seam_model(const pattern::Pattern& pattern) {
  SeamModel model;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    add_panel(pattern.panels[p], static_cast<Index>(p), model);
    model.words.push_back(words_of(pattern.panels[p].id));
    model.up.push_back(normalized(pattern.panels[p].grain));
    // Sleeves are often drawn lying, and files without grain lines have it upright.
    model.upright.push_back(!model.words[p].limb || pattern.panels[p].grain != Vec2{0, 1});
  }
  model.girth.assign(pattern.panels.size(), 0);
  for (const SeamRun& run : model.runs) model.girth[run.panel] += run.length;
  find_mirrors(model);
  match_mirrors(model);
  model.counterparts.resize(model.runs.size());
  model.same.resize(model.runs.size());
  const auto count = static_cast<Index>(model.words.size());
  for (Index p = 0; p < count; ++p) {
    for (Index q = p + 1; q < count; ++q) {
      if (model.twin[p] != q) find_counterparts(model, p, q);
      find_same(model, p, q);
    }
  }
  return model;
}

SeamModel with_cuts(const pattern::Pattern& pattern, SeamModel model, Index r,
                    const std::vector<double>& cuts) {
  const pattern::PanelEdge& edge = pattern.panels[model.runs[r].panel].outline.edges[model.runs[r].edge];
  const SeamRun whole = model.runs[r];
  const double per_mm = (whole.to - whole.from) / whole.length;
  Index at = r;
  for (const double cut : cuts) {
    const double f = whole.from + cut * per_mm;
    SeamRun rest = whole;
    rest.from = f;
    rest.angle = 180;
    rest.next = whole.next;
    model.runs[at].to = f;
    model.runs[at].next = static_cast<Index>(model.runs.size());
    measure(edge, model.runs[at]);
    measure(edge, rest);
    at = model.runs[at].next;
    model.runs.push_back(std::move(rest));
    model.counterparts.emplace_back();
    model.same.emplace_back();
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
  match_mirrors(model);
  return model;
}

}  // namespace toile::seams
