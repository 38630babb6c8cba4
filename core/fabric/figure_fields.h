#pragma once
// Figures of cloth that have the same key, unit and meaning wherever they stand: in fabric files, in a
// document's fabrics, and as what a piece has otherwise than its fabric.

#include "core/json/fields/range.h"

namespace toile::fields {

inline constexpr Range kStiffness{0.01, 1e6};
inline constexpr Range kRigidity{0, 1e6};
inline constexpr Range kFriction{0, 2};

template <typename Visitor, typename Cloth>
void describe_areal_mass(Visitor& v, Cloth& cloth, Need need = Need::kOptional) {
  v.field("areal_mass_g_m2", cloth.areal_mass_g_m2, "g/m².", need, Range{1, 10000});
}

template <typename Visitor, typename Cloth>
void describe_thickness(Visitor& v, Cloth& cloth, Need need = Need::kOptional) {
  v.field("thickness_mm", cloth.thickness_mm, "mm; also the distance that layers keep.", need,
          Range{0.01, 50});
}

template <typename Visitor, typename Cloth>
void describe_shear(Visitor& v, Cloth& cloth, Need need = Need::kOptional) {
  v.field("stretch_shear_n_m", cloth.stretch_shear_n_m, "N/m per radian of shear.", need, kStiffness);
}

/// `range`: of a fabric file's, which is measured, no rigidity is 0.
template <typename Visitor, typename Cloth>
void describe_bending(Visitor& v, Cloth& cloth, Need need = Need::kOptional, Range range = kRigidity) {
  v.field("bend_warp_un_m", cloth.bend_warp_un_m,
          "µN·m; bending rigidity per width of a strip cut along the warp.", need, range);
  v.field("bend_weft_un_m", cloth.bend_weft_un_m, "µN·m; of a strip cut along the weft.", need, range);
  v.field("bend_bias_un_m", cloth.bend_bias_un_m, "µN·m; of a strip cut at 45°.", need, range);
}

template <typename Visitor, typename Cloth>
void describe_colour(Visitor& v, Cloth& cloth, Need need = Need::kOptional) {
  v.field("colour", cloth.colour, "Linear red, green and blue for pictures, 0 to 1.", need, Range{0, 1});
}

}  // namespace toile::fields
