#include "tests/garments/random_garment.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "tests/garments/random_chance.h"
#include "tests/garments/random_forms.h"
#include "tests/garments/random_pieces.h"

namespace toile::test {
namespace {

/// Vertices × substeps of a case: about a second.
constexpr double kWork = 1.2e6;
constexpr double kLeastParticles = 60, kMostParticles = 1200;
constexpr int kFrames = 280;  // of a drape that takes all its time; one that settles early still has 100

/// What a scene adds to: the garment so far and what it is made by.
struct Maker {
  Chance& chance;
  RandomGarment& out;
  double spacing;  ///< m, the particle distance
  double size;     ///< m, side of a square with the area of a piece
  int count;       ///< of pieces
  Form form;
  std::vector<CutPiece> pieces;
  std::vector<std::vector<bool>> sewn{};  ///< per piece and edge

  CutPiece cut(double width, double height) {
    return cut_piece(chance, "p" + std::to_string(pieces.size()), mm_from_metres(width),
                     mm_from_metres(height), mm_from_metres(spacing));
  }
  CutPiece cut() {
    const double aspect = chance.log_between(0.4, 2.5);
    return cut(size * std::sqrt(aspect), size / std::sqrt(aspect));
  }
  double gap() { return chance.log_between(1.5e-3, 30e-3); }
};

double metres_wide(const CutPiece& p) { return metres_from_mm(p.box.size().x); }
double metres_high(const CutPiece& p) { return metres_from_mm(p.box.size().y); }

void add(Maker& m, CutPiece piece, sewing::Placement placement) {
  m.out.shapes += (m.pieces.empty() ? "" : ",") + piece.shape;
  m.sewn.emplace_back(pattern::edges_of(piece.panel).size(), false);
  m.out.input.pattern.panels.push_back(piece.panel);
  m.out.input.placements.push_back(std::move(placement));
  m.pieces.push_back(std::move(piece));
}

/// The flat middle of the piece comes to `centre`.
sewing::RigidPlacement centred(const CutPiece& piece, Vec3 centre, Vec3 rotation, bool flipped = false) {
  sewing::RigidPlacement p{{}, rotation, flipped};
  const Vec2 middle = piece.box.middle() * 1e-3;
  p.translation = centre - sewing::place({middle}, p)[0];
  return p;
}

void sew_edges(Maker& m, std::vector<pattern::SeamEdge> a, std::vector<pattern::SeamEdge> b,
               bool same_direction) {
  for (const auto* series : {&a, &b}) {
    for (const pattern::SeamEdge& e : *series) {
      if (m.sewn[e.panel][e.edge]) return;
    }
  }
  for (const auto* series : {&a, &b}) {
    for (const pattern::SeamEdge& e : *series) m.sewn[e.panel][e.edge] = true;
  }
  pattern::Seam seam;
  seam.id = "s" + std::to_string(m.out.input.pattern.seams.size());
  seam.a = std::move(a);
  seam.b = std::move(b);
  seam.same_direction = same_direction;
  m.out.input.pattern.seams.push_back(std::move(seam));
}

std::vector<pattern::SeamEdge> series(const Maker& m, Index piece, int side) {
  std::vector<pattern::SeamEdge> edges;
  for (const Index e : m.pieces[piece].sides[side]) edges.push_back({piece, e, false});
  return edges;
}

void sew(Maker& m, Index p, int side_p, Index q, int side_q, bool same_direction) {
  if (p == q && side_p == side_q) return;
  sew_edges(m, series(m, p, side_p), series(m, q, side_q), same_direction);
}

/// Sheets one above the other over the form, like pages; some sewn to the next along some sides.
void stack(Maker& m) {
  double y = m.form.box.high.y + m.gap() + 0.004;
  const double tilt = m.chance.happens(0.3) ? m.chance.between(-0.5, 0.5) : 0;
  y += std::abs(std::sin(tilt)) * m.size;
  const bool alike = m.chance.happens(0.5);
  const double shift = m.chance.between(0, 0.4) * m.size;
  for (int k = 0; k < m.count; ++k) {
    CutPiece piece = alike && k > 0 ? copy_of(m.pieces[0], "p" + std::to_string(k)) : m.cut();
    const Vec3 centre{m.chance.between(-shift, shift), y, m.chance.between(-shift, shift)};
    const sewing::RigidPlacement at = alike && k > 0
                                          ? centred(piece, {0, y, 0}, {-kPi / 2, 0, tilt})
                                          : centred(piece, k ? centre : Vec3{0, y, 0}, {-kPi / 2, 0, tilt});
    add(m, std::move(piece), at);
    y += m.gap() / std::cos(tilt);
  }
  for (Index k = 0; k + 1 < m.count; ++k) {
    for (int side = k % 2; side < 4; side += m.count == 2 ? 1 : 2) {
      if (m.chance.happens(0.6)) sew(m, k, side, k + 1, side, true);
    }
  }
}

/// Pairs before and behind the form, sewn at their sides into tubes, the tubes sewn to each other.
void before_and_behind(Maker& m) {
  const double away = m.form.reach() + m.chance.log_between(3e-3, 80e-3) + 1e-3;
  const double slack = m.chance.log_between(0.8, 2.5);
  const double width = std::clamp(2 * m.form.reach() * 1.6 * slack, 0.3 * m.size, 2.5 * m.size);
  double top = m.form.box.low.y + m.form.box.size().y * m.chance.between(0.4, 1.1);
  for (int row = 0; row < std::max(1, m.count / 2); ++row) {
    const double gather = row == 0 || m.chance.happens(0.5) ? 1 : m.chance.log_between(1.0 / 3, 3);
    CutPiece front = m.cut(width * gather, m.size * m.size / width * m.chance.between(0.3, 1));
    CutPiece back = m.chance.happens(0.8)
                        ? copy_of(front, "p" + std::to_string(m.pieces.size() + 1))
                        : cut_piece(m.chance, "p" + std::to_string(m.pieces.size() + 1), front.box.size().x,
                                    front.box.size().y, 1e3 * m.spacing);
    const double high = std::max(metres_high(front), metres_high(back));
    const Vec3 centre{0, top - high / 2, away};
    const Index f = static_cast<Index>(m.pieces.size()), b = f + 1;
    const sewing::RigidPlacement at_front = centred(front, centre, {});
    const sewing::RigidPlacement at_back = centred(back, {0, centre.y, -away}, {});
    add(m, std::move(front), at_front);
    add(m, std::move(back), at_back);
    sew(m, f, kRight, b, kRight, true);
    sew(m, f, kLeft, b, kLeft, true);
    if (row > 0) {
      sew(m, f - 2, kBottom, f, kTop, false);
      sew(m, b - 2, kBottom, b, kTop, false);
    }
    top -= high + m.gap();
  }
}

/// Tubes rolled around the form's axis, each of one piece or more, sewn shut and to the next below.
void wrapped(Maker& m) {
  const double radius = m.form.reach() * 1.4 + 1e-3 + m.chance.log_between(2e-3, 60e-3);
  const int around = m.chance.whole(1, std::min(3, m.count)), rows = m.count / around;
  const double slope = m.chance.happens(0.3) ? m.chance.between(-0.3, 0.3) : 0;
  double top = m.form.box.low.y + m.form.box.size().y * m.chance.between(0.5, 1.05);
  for (int row = 0; row < rows; ++row) {
    const double width = 2 * kPi * radius / around * m.chance.between(0.6, 0.93);
    const double height = std::min(m.size * m.size / width, 3 * radius + 0.1) * m.chance.between(0.3, 1);
    const CutPiece first = m.cut(width, height);
    const auto begin = static_cast<Index>(m.pieces.size());
    for (int k = 0; k < around; ++k) {
      sewing::WrappedPlacement w;
      w.radius = radius;
      w.slope = slope;
      w.anchor = first.box.middle() * 1e-3;
      w.angle = 2 * kPi * k / around;
      w.height = top - metres_high(first) / 2;
      add(m, copy_of(first, "p" + std::to_string(m.pieces.size())), w);
    }
    for (int k = 0; k < around; ++k) sew(m, begin + k, kRight, begin + (k + 1) % around, kLeft, false);
    for (int k = 0; k < around && row > 0; ++k) sew(m, begin - around + k, kBottom, begin + k, kTop, false);
    top -= metres_high(first) + m.gap();
  }
}

void hold(Maker& m, Index piece, int side, double release) {
  sewing::Attachment a;
  a.id = "hold" + std::to_string(m.out.input.attachments.size());
  a.panel = piece;
  if (side >= 0) a.edges = m.pieces[piece].sides[side];
  a.hold = m.chance.happens(0.5) ? sewing::Attachment::Hold::kHeight : sewing::Attachment::Hold::kPlace;
  a.release_after = release;
  m.out.input.attachments.push_back(std::move(a));
}

/// Upright sheets behind each other before the form, held at the top or not.
void hanging(Maker& m) {
  double z = m.form.box.high.z + m.gap() + 2e-3;
  for (int k = 0; k < m.count; ++k) {
    CutPiece piece = m.cut();
    const double y = m.form.box.high.y + m.chance.between(-0.5, 0.5) * metres_high(piece);
    const sewing::RigidPlacement at = centred(piece, {m.chance.between(-0.3, 0.3) * m.size, y, z},
                                              {0, 0, m.chance.between(-0.3, 0.3)}, m.chance.happens(0.3));
    add(m, std::move(piece), at);
    if (m.chance.happens(0.7)) hold(m, k, kTop, m.chance.happens(0.6) ? -1 : m.chance.between(0, 0.4));
    if (k > 0 && m.chance.happens(0.5)) sew(m, k - 1, kBottom, k, kBottom, m.chance.happens(0.7));
    z += m.gap();
  }
}

/// Pieces side by side in a plane over the form, sewn like a quilt: seams of unlike lengths, seams that meet.
void side_by_side(Maker& m) {
  const double y = m.form.box.high.y + m.gap() + 0.004;
  double x = 0, back = 0;
  const int across = m.count > 3 ? (m.count + 1) / 2 : m.count;
  for (int k = 0; k < m.count; ++k) {
    if (k == across) {
      x = 0;
      back = 1.5 * m.size + m.gap();
    }
    const double taller = m.chance.happens(0.4) ? m.chance.log_between(1.0 / 3, 3) : 1;
    CutPiece piece = m.cut(m.size * m.chance.between(0.4, 1), m.size * std::min(taller, 1.4));
    x += metres_wide(piece) / 2;
    const sewing::RigidPlacement at = centred(piece, {x - m.size * across * 0.4, y, back}, {-kPi / 2, 0, 0});
    x += metres_wide(piece) / 2 + m.gap();
    add(m, std::move(piece), at);
    if (k % across > 0) sew(m, k - 1, kRight, k, kLeft, false);
    if (k >= across && m.chance.happens(0.7)) sew(m, k - across, kBottom, k, kTop, false);
  }
}

/// Rings around a pole.
void ringed(Maker& m) {
  const double hole =
      std::max(2 * m.spacing, m.chance.log_between(0.008, 0.25) * std::min(1.0, 2.5 * m.size));
  m.form = make_pole(m.chance, hole * m.chance.between(0.2, 0.85), m.size * 2 + 0.1);
  double y = m.form.box.low.y + m.form.box.size().y * m.chance.between(0.5, 0.9);
  const bool slit = m.chance.happens(0.5);
  for (int k = 0; k < m.count; ++k) {
    const double outer = hole + m.size * m.chance.between(0.25, 0.6);
    CutPiece ring =
        cut_ring(m.chance, "p" + std::to_string(k), mm_from_metres(hole), mm_from_metres(outer), slit);
    const Vec2 flat = ring.box.middle() * 1e-3;  // the hole's middle is the flat origin
    add(m, ring, centred(ring, {flat.x, y, -flat.y}, {-kPi / 2, 0, 0}));
    if (slit && m.chance.happens(0.7)) sew(m, k, kRight, k, kLeft, false);
    if (k > 0 && m.chance.happens(0.5)) sew(m, k - 1, kBottom, k, kBottom, true);
    y += m.gap();
  }
}

/// Anything anywhere, any side sewn to any other.
void anywhere(Maker& m) {
  const double around = m.form.reach() + 0.6 * m.size;
  for (int k = 0; k < m.count; ++k) {
    CutPiece piece = m.cut();
    const double angle = 2 * kPi * (k + m.chance.between(0, 0.4)) / m.count;
    const double far = around * m.chance.between(0.9, 1.8);
    const Vec3 centre{far * std::sin(angle), 1 + m.chance.between(-0.5, 1) * m.size, far * std::cos(angle)};
    const Vec3 rotation{m.chance.between(-0.6, 0.6), angle, m.chance.between(-3, 3)};
    const sewing::RigidPlacement at = centred(piece, centre, rotation, m.chance.happens(0.3));
    add(m, std::move(piece), at);
  }
  for (int k = m.chance.whole(0, m.count + 1); k > 0; --k) {
    const Index p = m.chance.whole(0, m.count - 1), q = m.chance.whole(0, m.count - 1);
    sew(m, p, m.chance.whole(0, 3), q, m.chance.whole(0, 3), m.chance.happens(0.5));
  }
}

material::Fabric random_fabric(Chance& chance, int k) {
  material::Fabric f;
  f.id = "f" + std::to_string(k);
  f.areal_mass = chance.log_between(0.03, 1);
  f.stretch_warp = chance.log_between(50, 20000);
  f.stretch_weft = std::clamp(f.stretch_warp * chance.log_between(0.1, 10), 50.0, 20000.0);
  const double mean = std::sqrt(f.stretch_warp * f.stretch_weft);
  f.stretch_coupling = chance.between(-0.3, 0.9) * mean;
  f.stretch_shear = mean * chance.log_between(0.01, 1);
  f.bend_warp = chance.log_between(1e-7, 1e-3);
  f.bend_weft = std::clamp(f.bend_warp * chance.log_between(0.1, 10), 1e-7, 1e-3);
  f.bend_bias = std::sqrt(f.bend_warp * f.bend_weft) * chance.log_between(0.3, 3);
  f.thickness = chance.log_between(0.1e-3, 5e-3);
  f.friction = chance.happens(0.2) ? 0 : chance.between(0, 1);
  return f;
}

void set_times(Chance& chance, drape::DrapeSettings& s) {
  s.time_step = 1 / chance.log_between(1000, 6000);
  s.gravity = chance.happens(0.1) ? 0 : chance.happens(0.4) ? 9.81 : chance.between(0, 30);
  s.sew_time = chance.happens(0.05) ? 0 : chance.log_between(0.1, 0.8);
  // Long enough to come to rest, or cut short.
  s.max_time = s.sew_time + (chance.happens(0.6) ? chance.between(2.2, 3.2) : chance.between(0.2, 1.2));
  s.frame_interval = std::max(1, static_cast<int>(s.max_time / s.time_step / kFrames));
}

void finish(Maker& m) {
  drape::DrapeInput& input = m.out.input;
  for (Index p = 0; p < static_cast<Index>(m.pieces.size()); ++p) {
    for (const auto& [a, b] : m.pieces[p].darts) sew_edges(m, {{p, a, false}}, {{p, b, false}}, false);
  }
  const int fabrics = m.chance.whole(1, 3);
  for (int k = 0; k < fabrics; ++k) input.fabrics.push_back(random_fabric(m.chance, k));
  for (pattern::Panel& panel : input.pattern.panels) {
    const Index f = m.chance.whole(0, fabrics - 1);
    panel.fabric = input.fabrics[f].id;
    input.fabric_of_panel.push_back(f);
  }
  if (m.chance.happens(0.3)) {
    hold(m, m.chance.whole(0, static_cast<int>(m.pieces.size()) - 1), m.chance.whole(-1, 3),
         m.chance.happens(0.4) ? -1 : m.chance.between(0, 0.5));
  }
  input.bodies = std::move(m.form.bodies);
  if (m.chance.happens(0.1)) {
    const int steps = static_cast<int>(input.settings.max_time / input.settings.time_step);
    m.out.cancel_at_step = m.chance.happens(0.1) ? 0 : m.chance.whole(1, steps);
  }
}

}  // namespace

RandomGarment random_garment(std::uint64_t seed) {
  struct Scene {
    const char* name;
    void (*make)(Maker&);
  };
  static const Scene kScenes[] = {
      {"stack", stack},      {"before and behind", before_and_behind}, {"wrapped", wrapped},
      {"hanging", hanging},  {"side by side", side_by_side},           {"ringed", ringed},
      {"anywhere", anywhere}};
  Chance chance(seed * 1000003 + 17);
  RandomGarment out;
  drape::DrapeSettings& settings = out.input.settings;
  out.input.name = "random " + std::to_string(seed);
  set_times(chance, settings);
  settings.particle_distance = chance.log_between(0.003, 0.04);
  const double affordable = kWork / (settings.max_time / settings.time_step);
  const double particles = std::clamp(affordable, kLeastParticles, kMostParticles) * chance.between(0.4, 1);
  const double area = particles * 0.866 * settings.particle_distance * settings.particle_distance;
  const Scene& scene = kScenes[chance.whole(0, 6)];
  const int count = chance.whole(1, 6);
  const double size = std::sqrt(area / count);
  Maker maker{chance, out, settings.particle_distance, size, count, make_form(chance, std::sqrt(area)), {}};
  out.scene = scene.name;
  scene.make(maker);
  out.form = maker.form.kind;
  finish(maker);
  return out;
}

}  // namespace toile::test
