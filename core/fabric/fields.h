#pragma once
// The fields of fabric files, as core/project/fields.h has those of documents.

#include "core/fabric/card.h"
#include "core/fabric/figure_fields.h"
#include "core/json/fields/range.h"

namespace toile::fields {

inline constexpr Range kBendingRange{0.01, 1e6};
inline constexpr Range kCurvePoints{1, 100};

template <typename Visitor>
void describe(Visitor& v, fabric::CurvePoint& point) {
  v.object("curve_point", "A point of a curve of tension over strain, which begins at 0, 0.");
  v.field("strain_percent", point.strain_percent, "%; more than at the point before.", Need::kRequired,
          Range{0.01, 1000});
  v.field("tension_n_m", point.tension_n_m, "N/m; more than at the point before.", Need::kRequired,
          Range{0.001, 1e6});
}

template <typename Visitor>
void describe(Visitor& v, fabric::FigureSource& source) {
  v.object("figure_source", "Where figures come from.");
  v.field("of", source.of, "Their keys; every figure of the file stands in one such list.", Need::kRequired,
          kCurvePoints);
  v.field("source", source.source, "Who measured them, and when.");
  v.field("estimated_from", source.estimated_from, "What they are estimated from: nobody measured them.");
  v.exactly_one("source", "estimated_from");
}

template <typename Visitor>
void describe_stretch(Visitor& v, fabric::FabricCard& card) {
  v.field("stretch_warp", card.stretch_warp,
          "Tension over strain along the warp, or along a knit's wales. The solver takes the slope of the "
          "first part, and as its limit the strain where that line meets the line of the last part.",
          Need::kRequired, kCurvePoints);
  v.field("stretch_weft", card.stretch_weft, "The same along the weft, or along a knit's courses.",
          Need::kRequired, kCurvePoints);
  v.field("stretch_coupling_n_m", card.stretch_coupling_n_m,
          "N/m; tension along one per strain along the other at small strain; its square is less than the "
          "product of both first stiffnesses.",
          Need::kRequired, Range{-1e6, 1e6});
  describe_shear(v, card, Need::kRequired);
  v.field("limit_shear_rad", card.limit_shear_rad,
          "Radians of shear beyond which the cloth is much stiffer. 0: never.", Need::kRequired,
          Range{0, 1.5});
}

template <typename Visitor>
void describe(Visitor& v, fabric::FabricCard& card) {
  v.object("", "A fabric of the library: what it is, its figures, and where each of them comes from.");
  v.field("toile_fabric", card.toile_fabric, "Version of this format.", Need::kRequired, Range{1, 1});
  v.field("name", card.name, "As documents name it: small letters, digits and hyphens; the file's own name.",
          Need::kRequired);
  v.field("title", card.title, "What people call it.", Need::kRequired);
  v.field("fibre", card.fibre, "What it is spun of.", Need::kRequired);
  v.choice("construction", card.construction, "How it is made.",
           {"woven", "knit", "nonwoven", "net", "leather"}, Need::kRequired);
  v.field("weave", card.weave, "How its threads run, for the look.", Need::kRequired);
  v.field("use", card.use, "What is sewn of it.");
  describe_areal_mass(v, card, Need::kRequired);
  describe_thickness(v, card, Need::kRequired);
  describe_bending(v, card, Need::kRequired, kBendingRange);
  describe_stretch(v, card);
  v.field("friction", card.friction, "Coulomb's coefficient, cloth on cloth.", Need::kRequired, kFriction);
  v.field("drape_least_percent", card.drape_least_percent,
          "%; where the drape coefficient of such fabrics (30 cm on 18 cm) begins, where that is published.",
          Need::kOptional, Range{0, 100});
  v.field("drape_most_percent", card.drape_most_percent, "%; and where it ends.", Need::kOptional,
          Range{0, 100});
  describe_colour(v, card, Need::kRequired);
  v.field("sources", card.sources, "Where the figures come from; each of them stands in one.",
          Need::kRequired, kCurvePoints);
}

}  // namespace toile::fields
