#pragma once

#include <span>

namespace toile::image {

/// The tag Orientation, 1 to 8, of the data of a JPEG's APP1 segment (from "Exif" on); 1 when there is none
/// or the segment is damaged. Source: CIPA DC-008, 4.6.
int exif_orientation(std::span<const unsigned char> segment);

}  // namespace toile::image
