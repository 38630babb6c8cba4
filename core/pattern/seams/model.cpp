#include "core/pattern/seams/model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
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
    run.up = dot(normalized(-perpendicular(run.at.back() - run.at.front())), normalized(panel.grain));
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

/// The run of q that each run of p mirrors to, or nothing when q is not p turned over. Of several ways (a
/// rectangle has two) the one that keeps up what is up.
std::vector<Index> mirror_image(const SeamModel& m, Index p, Index q) {
  const std::vector<Index> a = runs_of(m, p), b = runs_of(m, q);
  const std::size_t n = a.size();
  if (n != b.size()) return {};
  std::vector<Index> best;
  double least = 0;
  for (std::size_t shift = 0; shift < n; ++shift) {
    std::vector<Index> image(n);
    bool all = true;
    double turned = 0;
    for (std::size_t k = 0; k < n && all; ++k) {
      image[k] = b[(shift + n - k) % n];
      all = mirrors(m, a[k], image[k]);
      turned += std::abs(m.runs[a[k]].up - m.runs[image[k]].up);
    }
    if (!all || (!best.empty() && turned >= least)) continue;
    best = std::move(image);
    least = turned;
  }
  return best;
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

/// Whether the two may be mirror images by their places in rows: the first is that of the last.
bool places_mirror(const PieceRow& a, const PieceRow& b) {
  return a.row == b.row && (a.row == kNone || a.place + b.place == a.size - 1);
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
        if (taken[q] || faces || (named ? sides >= 0 : sides > 0) || !places_mirror(m.rows[p], m.rows[q]))
          continue;
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

/// Edges of one length and turning that the two pieces have.
int edges_in_common(const SeamModel& m, Index p, Index q) {
  constexpr double kLeast = 30, kTurn = 4;  // mm, degrees
  int common = 0;
  for (const Index i : runs_of(m, p)) {
    const SeamRun& a = m.runs[i];
    if (a.length < kLeast) continue;
    for (const Index j : runs_of(m, q)) {
      const SeamRun& b = m.runs[j];
      if (!alike(a.length, b.length) || std::abs(a.turn.back() - b.turn.back()) > kTurn) continue;
      ++common;
      break;
    }
  }
  return common;
}

void find_rivals(SeamModel& m) {
  constexpr int kSeveral = 3;
  m.rival.assign(m.words.size(), 0);
  const auto count = static_cast<Index>(m.words.size());
  for (Index p = 0; p < count; ++p) {
    for (Index q = p + 1; q < count; ++q) {
      const PieceWords &a = m.words[p], &b = m.words[q];
      const bool named = a.face != 0 || a.side != 0;
      const bool one_role =
          (a.kind == b.kind || a.kind == PieceKind::kOther || b.kind == PieceKind::kOther) &&
          a.side == b.side && a.face == b.face && m.level[p] == m.level[q];
      const bool in_row = m.rows[p].row != kNone && m.rows[p].row == m.rows[q].row;
      if (!named || !one_role || in_row || m.twin[p] == q || edges_in_common(m, p, q) < kSeveral) continue;
      m.rival[p] = m.rival[q] = 1;
    }
  }
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

/// Pieces whose names differ by their last number alone, in its order: levels, where there is one without
/// any, else in a row.
void find_rows(const pattern::Pattern& pattern, SeamModel& m) {
  std::map<std::string, std::vector<std::pair<int, Index>>> rows;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const std::string& id = pattern.panels[p].id;
    const std::size_t end = id.find_last_not_of("0123456789") + 1;
    const std::optional<int> number = number_in<int>(std::string_view(id).substr(end));
    if (m.words[p].kind != PieceKind::kOther && number)
      rows[id.substr(0, end)].push_back({*number, static_cast<Index>(p)});
  }
  m.rows.assign(pattern.panels.size(), {});
  m.level.assign(pattern.panels.size(), 0);
  Index row = 0;
  for (auto& [stem, pieces] : rows) {
    std::sort(pieces.begin(), pieces.end());
    const std::string base = stem.substr(0, stem.find_last_not_of("_-. ") + 1);
    if (std::any_of(pattern.panels.begin(), pattern.panels.end(),
                    [&](const pattern::Panel& panel) { return panel.id == base; })) {
      // "skirt", "skirt_0", "skirt_1" lie one below the other
      for (std::size_t k = 0; k < pieces.size(); ++k) m.level[pieces[k].second] = static_cast<int>(k) + 1;
      continue;
    }
    for (std::size_t k = 0; k < pieces.size(); ++k)
      m.rows[pieces[k].second] = {row, static_cast<Index>(k), static_cast<Index>(pieces.size())};
    ++row;
  }
}

/// The middle of a bodice's half runs straight along the grain, and the crotch of a leg is hollow: on which
/// side of the pieces they lie says which way left and right are meant.
void find_hands(SeamModel& m) {
  double votes = 0, all = 0;
  for (const SeamRun& run : m.runs) {
    const PieceWords& words = m.words[run.panel];
    const bool middle = words.kind == PieceKind::kTorso && run.straight && std::abs(run.up) < 0.003;
    const bool crotch = words.kind == PieceKind::kLegs && run.turn.back() < -40 && std::abs(run.up) < 0.5;
    if (words.side * words.face == 0 || (!middle && !crotch)) continue;
    votes += words.side * words.face * faces_right(m, run) * run.length;
    all += run.length;
  }
  m.handed = std::abs(votes) < 0.3 * all || all == 0 ? 0 : votes > 0 ? 1 : -1;
}

/// Sleeves' caps: their edges that bulge most, and their mirror images. A sleeve whose cap is above stands,
/// also where no grain line says so.
void find_caps(SeamModel& m) {
  constexpr double kBulge = 10, kAbove = 0.8;  // degrees; facing
  std::vector<double> most(m.words.size(), kBulge);
  for (const SeamRun& run : m.runs) most[run.panel] = std::max(most[run.panel], run.turn.back());
  for (SeamRun& run : m.runs) {
    run.cap = m.words[run.panel].kind == PieceKind::kSleeve && run.turn.back() >= 0.8 * most[run.panel] &&
              run.turn.back() >= kBulge;
    if (run.cap && run.up > kAbove) m.upright[run.panel] = 1;
  }
}

/// Bands and cuffs, that other pieces hang from.
void find_between(SeamModel& m) {
  m.below_cuff.assign(m.words.size(), 0);
  for (const PieceWords& cuff : m.words) {
    m.has_band = m.has_band || cuff.kind == PieceKind::kBand;
    for (std::size_t p = 0; p < m.words.size() && cuff.kind == PieceKind::kCuff; ++p)
      if (m.words[p].kind == PieceKind::kFrill && m.words[p].leg == cuff.leg &&
          m.words[p].side * cuff.side >= 0)
        m.below_cuff[p] = 1;
  }
}

/// Whether the piece has another edge of the run's length that faces up as well: the sides of a wide skirt
/// do.
bool is_side(const SeamModel& m, Index r) {
  constexpr double kUp = 0.8;
  const SeamRun& run = m.runs[r];
  if (run.up < kUp) return false;
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& other) {
    return other.panel == run.panel && other.edge != run.edge && other.up > kUp &&
           alike(other.length, run.length);
  });
}

bool is_part_word(const std::string& w) {
  static const char* const kParts[] = {"torso", "bodice", "body", "panel", "skirt",
                                       "pant",  "leg",    "yoke", "sleeve"};
  return std::any_of(std::begin(kParts), std::end(kParts), [&](const char* part) { return w == part; });
}

/// The most telling word counts: a skirt of a cuff is a frill.
PieceKind kind_of(const std::vector<std::string>& words) {
  struct KindWord {
    const char* word;
    PieceKind kind;
  };
  static const KindWord kWords[] = {
      {"collar", PieceKind::kCollar}, {"hood", PieceKind::kHood},     {"lapel", PieceKind::kCollar},
      {"torso", PieceKind::kTorso},   {"ftorso", PieceKind::kTorso},  {"btorso", PieceKind::kTorso},
      {"bodice", PieceKind::kTorso},  {"wb", PieceKind::kBand},       {"waistband", PieceKind::kBand},
      {"skirt", PieceKind::kSkirt},   {"pant", PieceKind::kLegs},     {"pants", PieceKind::kLegs},
      {"trouser", PieceKind::kLegs},  {"trousers", PieceKind::kLegs}, {"leg", PieceKind::kLegs},
      {"sleeve", PieceKind::kSleeve}, {"slv", PieceKind::kSleeve},    {"cuff", PieceKind::kCuff},
      {"ins", PieceKind::kInsert},    {"insert", PieceKind::kInsert}, {"godet", PieceKind::kInsert},
      {"gusset", PieceKind::kInsert}};
  const auto has = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  if (has("cuff") && has("skirt")) return PieceKind::kFrill;
  PieceKind kind = PieceKind::kOther;
  for (const KindWord& known : kWords)
    if (has(known.word)) kind = known.kind;
  return kind;
}

}  // namespace

double corner_angle(const pattern::PanelEdge& before, const pattern::PanelEdge& after) {
  const double a = pattern::arc_length(before), b = pattern::arc_length(after);
  const Vec2 in = before.curves.back().p3 - pattern::point_at_length(before, a - end_reach(a));
  const Vec2 out = pattern::point_at_length(after, end_reach(b)) - after.curves.front().p0;
  return 180 - degrees_between(in, out);
}

double faces_right(const SeamModel& m, const SeamRun& run) {
  const Vec2 up = m.up[run.panel], right{up.y, -up.x};
  return dot(normalized(-perpendicular(run.at.back() - run.at.front())), right);
}

int hangs_from(PieceKind lower, PieceKind upper) {
  using enum PieceKind;
  if (lower == kOther || upper == kOther || lower == kInsert || upper == kInsert) return 0;
  const bool told = ((upper == kCollar || upper == kHood) && lower == kTorso) ||
                    (upper == kTorso && (lower == kBand || lower == kSkirt || lower == kLegs)) ||
                    (upper == kBand && (lower == kSkirt || lower == kLegs)) ||
                    ((upper == kSleeve || upper == kLegs) && lower == kCuff) ||
                    ((upper == kCuff || upper == kSleeve || upper == kLegs) && lower == kFrill) ||
                    (upper == kSkirt && lower == kSkirt);
  return told ? 1 : -1;
}

int hangs_from(const SeamModel& m, Index lower, Index upper) {
  using enum PieceKind;
  const PieceWords &x = m.words[lower], &y = m.words[upper];
  const bool past_band = m.has_band && y.kind == kTorso && (x.kind == kSkirt || x.kind == kLegs);
  const bool past_cuff = m.below_cuff[lower] && y.kind != kCuff;
  const bool other_limb =
      x.kind != kOther && y.kind != kOther && x.limb && (y.limb || y.leg) && x.leg != y.leg;
  const bool past_level = m.level[lower] != (x.kind == y.kind ? m.level[upper] + 1 : 0);
  if (x.kind == y.kind && !past_level) return hangs_from(x.kind, y.kind);
  return past_band || past_cuff || other_limb || (x.kind == PieceKind::kSkirt && past_level)
             ? -1
             : hangs_from(x.kind, y.kind);
}

bool ever_meet(PieceKind a, PieceKind b) {
  using enum PieceKind;
  if (a == kOther || b == kOther || a == b || a == kInsert || b == kInsert) return true;
  const auto either = [&](PieceKind x, PieceKind y) { return (a == x && b == y) || (a == y && b == x); };
  return hangs_from(a, b) == 1 || hangs_from(b, a) == 1 || either(kTorso, kSleeve);
}

PieceWords words_of(const std::string& name) {
  PieceWords words;
  words.kind = kind_of(words_of_name(name));
  words.leg = words.kind == PieceKind::kLegs;
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
    if (is({"pant", "pants", "trouser", "trousers", "leg"})) words.leg = true;
    if (is({"side", "sidepanel", "flank"})) words.flank = true;
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
    model.lines.push_back(static_cast<int>(pattern.panels[p].outline.edges.size()));
    model.up.push_back(normalized(pattern.panels[p].grain));
    // Sleeves are often drawn lying, and files without grain lines have it upright.
    model.upright.push_back(
        !model.words[p].limb || model.words[p].leg || model.words[p].kind == PieceKind::kCuff ||
        model.words[p].kind == PieceKind::kFrill || pattern.panels[p].grain != Vec2{0, 1});
  }
  model.girth.assign(pattern.panels.size(), 0);
  for (const SeamRun& run : model.runs) model.girth[run.panel] += run.length;
  find_rows(pattern, model);
  find_between(model);
  find_hands(model);
  find_caps(model);
  for (std::size_t r = 0; r < model.runs.size(); ++r)
    model.runs[r].side = is_side(model, static_cast<Index>(r));
  find_mirrors(model);
  match_mirrors(model);
  find_rivals(model);
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
