#include "core/warm/hung_garment.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/base/hash.h"
#include "core/base/state_bytes.h"

namespace toile::warm {

namespace {

constexpr std::string_view kMagic = "TOILEHG\n";
constexpr std::size_t kHashDigits = 32;
constexpr double kFarthest = 1e6;  // m; no drape gets there

Error damaged() {
  return {"hung.damaged", "the shape to go on from is cut off or has changed; drape from the start", "",
          ErrorKind::kInput};
}

void write(StateWriter& out, const HungPiece& piece) {
  out.value(piece.id);
  out.value(piece.rest);
  out.size(piece.triangles.size());
  for (const Tri& t : piece.triangles)
    for (const Index v : t) out.value(v);
  out.size(piece.edges.size());
  for (const HungEdge& edge : piece.edges) {
    out.value(edge.id);
    out.value(edge.vertices);
  }
  out.value(piece.positions);
  out.value(piece.preloads);
}

HungPiece read_piece(StateReader& in) {
  HungPiece piece;
  in.value(piece.id);
  in.value(piece.rest);
  in.value(piece.triangles);
  piece.edges.resize(in.count(2 * sizeof(std::uint32_t)));
  for (HungEdge& edge : piece.edges) {
    in.value(edge.id);
    in.value(edge.vertices);
  }
  in.value(piece.positions);
  in.value(piece.preloads);
  return piece;
}

HungPin read_pin(StateReader& in) {
  HungPin pin;
  in.value(pin.piece);
  in.value(pin.at);
  return pin;
}

bool within(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::abs(v) <= kFarthest; });
}

bool sound(const HungPiece& piece) {
  const auto known = [&](Index v) { return v >= 0 && static_cast<std::size_t>(v) < piece.rest.size(); };
  return piece.positions.size() == piece.rest.size() && piece.preloads.size() == piece.triangles.size() &&
         std::all_of(piece.rest.begin(), piece.rest.end(),
                     [](Vec2 p) {
                       return within({p.x, p.y});
                     }) &&
         std::all_of(piece.positions.begin(), piece.positions.end(),
                     [](Vec3 p) {
                       return within({p.x, p.y, p.z});
                     }) &&
         std::all_of(piece.preloads.begin(), piece.preloads.end(),
                     [](Vec3 p) { return std::abs(p.x) <= 1 && std::abs(p.y) <= 1 && std::abs(p.z) <= 1; }) &&
         std::all_of(piece.triangles.begin(), piece.triangles.end(),
                     [&](const Tri& t) { return std::all_of(t.begin(), t.end(), known); }) &&
         std::all_of(piece.edges.begin(), piece.edges.end(), [&](const HungEdge& edge) {
           return edge.vertices.size() > 1 && std::all_of(edge.vertices.begin(), edge.vertices.end(), known);
         });
}

bool sound(const HungPin& pin, const std::vector<HungPiece>& pieces) {
  return within({pin.at.x, pin.at.y}) &&
         std::any_of(pieces.begin(), pieces.end(), [&](const HungPiece& p) { return p.id == pin.piece; });
}

}  // namespace

HungGarment flat_pieces(const pattern::Pattern& pattern, const mesh::PanelMeshes& meshes) {
  HungGarment hung;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const mesh::PanelMesh& flat = meshes.panels[p];
    HungPiece piece{pattern.panels[p].id, flat.rest, flat.triangles, {}, {}, {}};
    const std::vector<const pattern::PanelEdge*> edges = pattern::edges_of(pattern.panels[p]);
    for (std::size_t e = 0; e < edges.size(); ++e)
      piece.edges.push_back({edges[e]->id, flat.edge_vertices[e]});
    hung.pieces.push_back(std::move(piece));
  }
  return hung;
}

void hang(const sewing::GarmentMesh& garment, std::span<const Vec3> positions, std::span<const Vec3> preloads,
          HungGarment& hung) {
  TOILE_CHECK(hung.pieces.size() + 1 == garment.first_vertex.size());
  for (std::size_t p = 0; p < hung.pieces.size(); ++p) {
    const Index first = garment.first_vertex[p], last = garment.first_vertex[p + 1];
    hung.pieces[p].positions.assign(positions.begin() + first, positions.begin() + last);
    hung.pieces[p].preloads.clear();
  }
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const auto panel = static_cast<std::size_t>(garment.panel_of_triangle[t]);
    hung.pieces[panel].preloads.push_back(t < preloads.size() ? preloads[t] : Vec3{});
  }
}

std::string encode_hung(const HungGarment& hung) {
  StateWriter out;
  out.raw(kMagic);
  out.value(hung.pins.empty() ? kHungVersion : kHungVersionWithPins);
  out.size(hung.pieces.size());
  for (const HungPiece& piece : hung.pieces) write(out, piece);
  if (!hung.pins.empty()) out.size(hung.pins.size());
  for (const HungPin& pin : hung.pins) {
    out.value(pin.piece);
    out.value(pin.at);
  }
  out.raw(hash_of(std::string_view(out.bytes())));
  return out.take();
}

Result<HungGarment> decode_hung(std::string_view bytes) {
  if (bytes.size() < kMagic.size() + kHashDigits) return damaged();
  const std::string_view sealed = bytes.substr(0, bytes.size() - kHashDigits);
  if (hash_of(sealed) != bytes.substr(sealed.size())) return damaged();
  StateReader in(sealed);
  if (in.raw(kMagic.size()) != kMagic) return damaged();
  std::uint32_t version = 0;
  in.value(version);
  if (version != kHungVersion && version != kHungVersionWithPins)
    return Error{"hung.version", "the shape to go on from is of another version; drape from the start", "",
                 ErrorKind::kInput};
  HungGarment hung;
  const std::size_t count = in.count(sizeof(std::uint32_t));
  for (std::size_t p = 0; in.ok() && p < count; ++p) {
    hung.pieces.push_back(read_piece(in));
    if (!sound(hung.pieces.back())) return damaged();
  }
  const std::size_t pins = version == kHungVersionWithPins ? in.count(2 * sizeof(double)) : 0;
  for (std::size_t p = 0; in.ok() && p < std::min(pins, kMostHungPins); ++p) {
    hung.pins.push_back(read_pin(in));
    if (!sound(hung.pins.back(), hung.pieces)) return damaged();
  }
  const bool told = version == kHungVersion || (pins > 0 && pins <= kMostHungPins);
  if (!in.ok() || !in.at_end() || !told) return damaged();
  return hung;
}

}  // namespace toile::warm
