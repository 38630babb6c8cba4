#include "server/documents/stream_pieces.h"

namespace toile::documents {

std::vector<proto::StreamPiece> stream_pieces(const drape::DrapeInput& input,
                                              const sewing::GarmentMesh& garment) {
  std::vector<proto::StreamPiece> pieces;
  for (std::size_t p = 0; p < input.pattern.panels.size(); ++p) {
    const double* colour = input.fabrics[static_cast<std::size_t>(input.fabric_of_panel[p])].colour;
    pieces.push_back({input.pattern.panels[p].id,
                      garment.first_vertex[p],
                      garment.first_vertex[p + 1] - garment.first_vertex[p],
                      {colour[0], colour[1], colour[2]}});
  }
  return pieces;
}

}  // namespace toile::documents
