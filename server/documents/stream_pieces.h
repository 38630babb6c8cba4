#pragma once

#include <vector>

#include "core/drape/drape_input.h"
#include "core/sewing/garment_mesh.h"
#include "proto/cpp/frame_codec.h"

namespace toile::documents {

/// The garment's pieces as viewers show them, each in its cloth's colour.
std::vector<proto::StreamPiece> stream_pieces(const drape::DrapeInput& input,
                                              const sewing::GarmentMesh& garment);

}  // namespace toile::documents
