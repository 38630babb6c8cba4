#pragma once
// A fabric as a file says it: figures in the units of their keys, each with where it comes from.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/json/tree.h"
#include "core/material/fabric.h"

namespace toile::fabric {

/// A point of a curve of tension over strain; the curve begins at no strain and no tension.
struct CurvePoint {
  double strain_percent = 0;
  double tension_n_m = 0;
  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};
using StretchCurve = std::vector<CurvePoint>;

/// Where figures come from: measured by somebody, or estimated from something. One of the two.
struct FigureSource {
  std::vector<std::string> of;  ///< keys of the card
  std::string source;
  std::string estimated_from;
  friend bool operator==(const FigureSource&, const FigureSource&) = default;
};

/// Units as the keys name them; what each figure means stands in core/material/fabric.h.
struct FabricCard {
  int toile_fabric = 1;  ///< version of the format
  std::string name;      ///< as documents use it: small letters, digits and hyphens; unique
  std::string title;     ///< as people call it
  std::string fibre;
  std::string construction;  ///< "woven", "knit", "nonwoven", "net", "leather"
  std::string weave;         ///< for the look: "plain", "2/1 twill", "1x1 rib", …
  std::string use;           ///< what it is sewn to
  double areal_mass_g_m2 = 0;
  double thickness_mm = 0;
  double bend_warp_un_m = 0, bend_weft_un_m = 0, bend_bias_un_m = 0;
  StretchCurve stretch_warp, stretch_weft;
  double stretch_coupling_n_m = 0;
  double stretch_shear_n_m = 0;
  double limit_shear_rad = 0;
  double friction = 0;
  std::optional<double> drape_least_percent = {}, drape_most_percent = {};
  std::array<double, 3> colour{};
  std::vector<FigureSource> sources;
  friend bool operator==(const FabricCard&, const FabricCard&) = default;
};

/// Reads a fabric file. Errors: json.*, project.* as of documents, and fabric.curve, fabric.unstable,
/// fabric.source (a figure without its source, or with two); `where` is a JSON pointer.
Result<FabricCard> parse_fabric(std::string_view text);

/// The card as a tree, as files have it.
json::JsonValue fabric_json(const FabricCard& card);

/// The text of a fabric file; parse_fabric gives the same card back.
std::string write_fabric(const FabricCard& card);

/// How the solver takes a curve: a first stiffness, and the strain beyond which cloth is much stiffer.
struct StretchLaw {
  double stiffness = 0;  ///< N/m, slope of the curve's first part
  double limit = 0;      ///< strain where that line meets the line of the curve's last part; 0: it never does
};
StretchLaw stretch_law(const StretchCurve& curve);

/// The card in the solver's units. Stretch is taken in the form of StretchLaw, without hysteresis.
material::Fabric fabric_of(const FabricCard& card);

/// Peirce's bending length c = (B / w)^(1/3), m: of bending rigidity B (N·m) and weight per area w (N/m²).
/// A strip of length 2c held level at one end droops until its chord lies at 41.5°. After F. T. Peirce, "The
/// Handle of Cloth as a Measurable Quantity" (1930); ASTM D1388.
double bending_length(double rigidity, double areal_mass);

/// Edge length (m) of triangles that lets such cloth fold as it likes to: a third of its least bending
/// length, 6 to 15 mm.
double fitting_distance(const material::Fabric& fabric);

}  // namespace toile::fabric
