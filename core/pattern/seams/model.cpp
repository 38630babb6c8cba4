#include "core/pattern/seams/model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/aabb.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/pattern/curve.h"
#include "core/pattern/edge_ruler.h"
#include "core/pattern/seams/likeness.h"
#include "core/pattern/seams/named_by_shape.h"
#include "core/pattern/seams/named_layers.h"
#include "core/pattern/seams/named_strips.h"
#include "core/pattern/seams/piece_language.h"
#include "core/pattern/seams/piece_up.h"
#include "core/pattern/seams/roles.h"
#include "core/pattern/seams/second_layers.h"
#include "core/pattern/seams/shapes.h"
#include "core/pattern/seams/weights.h"

namespace toile::seams {
namespace {

double degrees_between(Vec2 from, Vec2 to) {
  return degrees_from_radians(std::atan2(cross(from, to), dot(from, to)));
}

/// How far along a run its direction at the ends is measured, mm: past the rounding of a drawn corner.
double end_reach(double length) { return std::min(2.0, length / 4); }

void measure(const pattern::EdgeRuler& edge, SeamRun& run) {
  const double start = run.from * edge.length();
  run.length = (run.to - run.from) * edge.length();
  for (std::size_t i = 0; i < SeamRun::kSamples; ++i)
    run.at[i] = edge.at(start + run.length * static_cast<double>(i) / (SeamRun::kSamples - 1));
  const Vec2 chord = run.at[SeamRun::kSamples - 1] - run.at[0];
  run.straight = true;
  for (const Vec2 p : run.at)
    run.straight = run.straight && std::abs(cross(chord, p - run.at[0])) <= 0.002 * run.length * run.length;
  double heading = 0;
  Vec2 before = run.at[1] - run.at[0];
  for (std::size_t i = 0; i + 1 < SeamRun::kSamples; ++i) {
    const Vec2 step = run.at[i + 1] - run.at[i];
    heading += degrees_between(before, step);
    run.turn[i] = heading;
    before = step;
  }
}

/// Whether the point may be less than `near` (mm) from the edge, whose curves lie within their handles'
/// boxes.
bool may_be_near(const pattern::PanelEdge& edge, Vec2 at, double near) {
  return std::any_of(edge.curves.begin(), edge.curves.end(), [&](const pattern::CubicBezier& c) {
    const Aabb2 box = bounding_box(std::array{c.p0, c.p1, c.p2, c.p3});
    return at.x > box.low.x - near && at.x < box.high.x + near && at.y > box.low.y - near &&
           at.y < box.high.y + near;
  });
}

/// Notches within 3 mm of the edge, as distances from its start.
std::vector<double> notches_on(const pattern::Panel& panel, const pattern::PanelEdge& edge,
                               const pattern::EdgeRuler& ruler) {
  constexpr double kNear = 3, kRounding = 1, kStep = 1, kFine = 0.05;  // mm
  std::vector<double> found;
  const double whole = ruler.length();
  for (const pattern::Notch& notch : panel.notches) {
    if (!may_be_near(edge, notch.at, kNear + kRounding)) continue;
    double best = kNear, where = -1;
    const auto look_at = [&](double s) {
      const double d = length(ruler.at(s) - notch.at);
      if (d >= best) return;
      best = d;
      where = s;
    };
    const int steps = std::clamp(static_cast<int>(whole / kStep), 2, 2000);
    for (int i = 0; i <= steps; ++i) look_at(whole * i / steps);
    if (where <= kNear || where >= whole - kNear) continue;
    const double rough = where;
    for (double s = rough - kStep; s < rough + kStep; s += kFine) look_at(s);
    found.push_back(where);
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
    run.fold = edges[e].id == pattern::kFoldEdge;
    run.next = first + static_cast<Index>((e + 1) % count);
    const pattern::EdgeRuler ruler(edges[e]);
    measure(ruler, run);
    run.up = dot(normalized(-perpendicular(run.at.back() - run.at.front())), model.up[index]);
    run.angle = corner_angle(edges[(e + count - 1) % count], edges[e]);
    if (!panel.notches.empty()) run.notches = notches_on(panel, edges[e], ruler);
    model.runs.push_back(std::move(run));
  }
}

/// Pieces whose names differ by their last number alone, in its order: levels, where there is one without
/// any, else in a row where there are several.
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
    if (pieces.size() < 2) continue;  // a number that ends one name alone is a size
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

/// Bands and cuffs, that other pieces hang from.
void find_between(SeamModel& m) {
  m.below_cuff.assign(m.words.size(), 0);
  const auto any = [&](PieceKind kind) {
    return std::any_of(m.words.begin(), m.words.end(), [&](const PieceWords& w) { return w.kind == kind; });
  };
  m.cut_on =
      any(PieceKind::kTorso) && any(PieceKind::kCuff) && !any(PieceKind::kSleeve) && !any(PieceKind::kLegs);
  for (const PieceWords& cuff : m.words) {
    m.has_band = m.has_band || cuff.kind == PieceKind::kBand;
    for (std::size_t p = 0; p < m.words.size() && cuff.kind == PieceKind::kCuff; ++p)
      if (m.words[p].kind == PieceKind::kFrill && m.words[p].leg == cuff.leg &&
          m.words[p].side * cuff.side >= 0)
        m.below_cuff[p] = 1;
  }
}

/// `line_turn`: an armhole may be drawn in parts, which go on from one to the next.
void find_line_turns(SeamModel& m) {
  const auto bend = [&](Index to) { return 180 - m.runs[to].angle; };  // where it begins, degrees
  const auto goes_on = [&](Index from, Index to) {
    return std::abs(bend(to)) < kGarmentWeights.smooth_deg && !begins_at_hem(m, m.runs[from]) &&
           !begins_at_hem(m, m.runs[to]);
  };
  std::vector<char> follows(m.runs.size(), 0), done(m.runs.size(), 0);
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r)
    follows[m.runs[r].next] = goes_on(r, m.runs[r].next);
  const auto add_up = [&](Index first) {
    std::vector<Index> line{first};
    double turn = m.runs[first].turn.back();
    for (Index at = m.runs[first].next; at != first && follows[at]; at = m.runs[at].next) {
      turn += bend(at) + m.runs[at].turn.back();
      line.push_back(at);
    }
    for (const Index r : line) {
      m.runs[r].line_turn = turn;
      done[r] = 1;
    }
  };
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r)
    if (!follows[r]) add_up(r);
  for (Index r = 0; r < static_cast<Index>(m.runs.size()); ++r)
    if (!done[r]) add_up(r);  // an outline without a corner
}

}  // namespace

double edge_length(const SeamRun& run) { return run.length / (run.to - run.from); }

std::vector<Index> first_runs(const pattern::Pattern& pattern) {
  std::vector<Index> first{0};
  for (const pattern::Panel& panel : pattern.panels)
    first.push_back(first.back() + static_cast<Index>(panel.outline.edges.size()));
  return first;
}

double corner_angle(const pattern::PanelEdge& before, const pattern::PanelEdge& after) {
  const double a = pattern::arc_length(before), b = pattern::arc_length(after);
  const Vec2 in = before.curves.back().p3 - pattern::point_at_length(before, a - end_reach(a));
  const Vec2 out = pattern::point_at_length(after, end_reach(b)) - after.curves.front().p0;
  return 180 - degrees_between(in, out);
}

bool has_shoulder(const SeamModel& m, Index panel) {
  const auto slopes = [](const SeamRun& run) {
    return bend_of(run) < kPairWeights.straight_deg && run.up > kPairWeights.level_shoulder_up;
  };
  return std::any_of(m.runs.begin(), m.runs.end(), [&](const SeamRun& run) {
    if (run.panel != panel) return false;
    const bool beside_side = begins_at_hem(m, m.runs[run.next]) || begins_at_hem(m, run_before(m, run));
    if (bend_of(run) < kPairWeights.straight_deg && lies_between_hollows(m, run) && !beside_side) return true;
    const SeamRun& neck = m.runs[run.next];
    const SeamRun& after = m.runs[neck.next];
    const bool pointed = equally_long(neck.length, after.length) && after.angle > kPairWeights.pointed_deg &&
                         after.angle < kPairWeights.dart_deg;
    const SeamRun& other = pointed ? m.runs[after.next] : after;
    const bool hollow = pointed || neck.turn.back() < kPairWeights.neck_deg;
    return &other != &run && slopes(run) && slopes(other) && equally_long(run.length, other.length) &&
           hollow && neck.up > (pointed ? 0 : kPairWeights.facing);
  });
}

bool is_lapel(const SeamModel& m, Index p) {
  return m.words[p].kind == PieceKind::kCollar && m.words[p].face > 0 && m.lines[p] < 4;
}

const SeamRun& run_before(const SeamModel& m, const SeamRun& run) {
  return *std::find_if(m.runs.begin(), m.runs.end(),
                       [&](const SeamRun& other) { return &m.runs[other.next] == &run; });
}

bool lies_between_hollows(const SeamModel& m, const SeamRun& run) {
  const auto hollow = [](const SeamRun& r) { return r.turn.back() < kPairWeights.neck_deg; };
  const SeamRun& after = m.runs[run.next];
  if (!hollow(after)) return false;
  const SeamRun& before = run_before(m, run);
  return &before != &after && hollow(before);
}

double faces_right(const SeamModel& m, const SeamRun& run) {
  const Vec2 up = m.up[run.panel], right{up.y, -up.x};
  return dot(normalized(-perpendicular(run.at.back() - run.at.front())), right);
}

int hangs_from(const SeamModel& m, Index lower, Index upper) {
  using enum PieceKind;
  const PieceWords &x = m.words[lower], &y = m.words[upper];
  const bool past_band = m.has_band && y.kind == kTorso && (x.kind == kSkirt || x.kind == kLegs);
  const bool past_cuff = m.below_cuff[lower] && y.kind != kCuff;
  const bool other_limb =
      x.kind != kOther && y.kind != kOther && x.limb && (y.limb || y.leg) && x.leg != y.leg;
  if (m.cut_on && x.kind == kCuff && y.kind == kTorso) return 1;
  const bool of_bodice = y.kind == kTorso ? x.face * y.face > 0 : y.kind == kOther && y.face == 0 && !y.layer;
  const bool on_yoke =
      x.kind == kTorso && of_bodice && y.yoke && !x.yoke && x.face != 0 && x.side * y.side >= 0;
  if (on_yoke) return 1;
  const bool past_level = m.level[lower] != (x.kind == y.kind ? m.level[upper] + 1 : 0);
  if (x.kind == y.kind && !past_level) return hangs_from(x.kind, y.kind);
  return past_band || past_cuff || other_limb || (x.kind == PieceKind::kSkirt && past_level)
             ? -1
             : hangs_from(x.kind, y.kind);
}

namespace {

/// A placket is buttoned in front; what only binds a slit may as well lie behind.
bool is_neck_placket(const PieceWords& words, const std::vector<std::string>& name) {
  const auto has = [&](const char* word) { return std::count(name.begin(), name.end(), word) > 0; };
  return words.kind != PieceKind::kTorso && !words.limb && has("placket") && !has("binding");
}

bool opens_below_neck(const pattern::Pattern& pattern, const SeamModel& m) {
  for (Index p = 0; p < static_cast<Index>(m.words.size()); ++p) {
    const PieceWords& words = m.words[p];
    const bool half = m.twin[p] != kNone && m.twin[p] != p;
    if (words.kind == PieceKind::kTorso && words.face > 0 && !words.layer && half) return true;
    if (is_neck_placket(words, words_of_piece(pattern.panels[p].id))) return true;
  }
  return false;
}

}  // namespace

SeamModel make_seam_model(const pattern::Pattern& pattern) {
  SeamModel model;
  model.words = words_of_garment(pattern);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    model.up.push_back(up_of_piece(pattern.panels[p], model.words[p]));
    add_panel(pattern.panels[p], static_cast<Index>(p), model);
    model.lines.push_back(static_cast<int>(pattern.panels[p].outline.edges.size()));
    // Sleeves are often drawn lying, and files without grain lines have it upright.
    model.upright.push_back(
        !model.words[p].limb || model.words[p].leg || model.words[p].kind == PieceKind::kCuff ||
        model.words[p].kind == PieceKind::kFrill || pattern.panels[p].grain != Vec2{0, 1});
  }
  model.girth.assign(pattern.panels.size(), 0);
  for (const SeamRun& run : model.runs) model.girth[run.panel] += run.length;
  find_layers_by_cloth(pattern, model);
  find_named_layers(pattern, model);
  find_second_layers(pattern, model);
  name_trunk(model);
  name_hem_bands(model);
  find_rows(pattern, model);
  find_line_turns(model);
  model.nameless = names_nothing(model);
  if (model.nameless) name_shapes(model);
  tell_front_and_back(model);
  find_twins(model);
  if (model.nameless) {
    name_by_fit(model);
    tell_front_and_back(model);
    find_twins(model);  // strips stand another way than they were drawn, and mirror themselves so
  } else {
    name_lone_sleeves(model);
    name_lone_neckband(model, neck_of(model));
  }
  name_legs(model);
  find_crotch_sides(model);
  name_skirts(model);
  name_leg_cuffs(model);
  find_between(model);
  find_hands(model);
  find_caps(model);
  find_standing_sleeves(model);
  find_raglan_sleeves(model);
  find_sides(model);
  match_mirrors(model);
  find_open_fronts(model);
  model.open_neck = opens_below_neck(pattern, model);
  find_banded_fronts(model);
  find_rivals(model);
  find_alike(model);
  return model;
}

bool has_open_neck(const pattern::Pattern& pattern) { return make_seam_model(pattern).open_neck; }

SeamModel with_cuts(const pattern::Pattern& pattern, SeamModel model, Index r,
                    const std::vector<double>& cuts) {
  const pattern::EdgeRuler edge(pattern.panels[model.runs[r].panel].outline.edges[model.runs[r].edge]);
  const SeamRun whole = model.runs[r];
  const double per_mm = (whole.to - whole.from) / whole.length;
  Index at = r;
  for (const double cut : cuts) {
    const double f = whole.from + cut * per_mm;
    SeamRun rest = whole;
    rest.from = f;
    rest.angle = 180;
    rest.next = whole.next;
    const bool notch = std::find(whole.notches.begin(), whole.notches.end(), cut) != whole.notches.end();
    rest.from_notch = notch;
    rest.to_notch = whole.to_notch;
    model.runs[at].to = f;
    model.runs[at].to_notch = notch;
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
  find_open_fronts(model);
  return model;
}

}  // namespace toile::seams
