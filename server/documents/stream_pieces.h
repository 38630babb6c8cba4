#pragma once

#include <vector>

#include "core/drape/drape_input.h"
#include "core/sewing/garment_mesh.h"
#include "proto/cpp/frame_codec.h"

namespace toile {

/// The garment's pieces as viewers show them, each in its cloth's colour.
std::vector<StreamPiece> stream_pieces(const DrapeInput& input, const GarmentMesh& garment);

}  // namespace toile
