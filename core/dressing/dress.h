#pragma once
// Puts a garment on a body: sews it around a slim figure of it, lets the figure grow, parts what crosses, and
// gives back a shape only with the certificate that it is on.

#include <functional>
#include <span>
#include <vector>

#include "core/base/run_context.h"
#include "core/dressing/certificate.h"
#include "core/dressing/effort.h"
#include "core/dressing/staging.h"
#include "core/dressing/wearer.h"
#include "core/sewing/assembly.h"

namespace toile::dressing {

/// Times its length that cloth gives way to.
struct Give {
  double growing = 1.05;      ///< while the body grows in it
  double coming_back = 1.02;  ///< while it comes back to its shape
  friend bool operator==(const Give&, const Give&) = default;
};

/// One way to try it.
struct DressingWay {
  Staging staging;
  double slim = 0.5;           ///< share of its half thickness by which the body is drawn in
  double least_stretch = 0.3;  ///< to which cloth may shrink while it is sewn
  double bending = 0.1;
  Give give = {};
};

struct Dressed {
  std::vector<Vec3> positions;  ///< m, one a garment vertex, sewn ones together
  Certificate certificate;
  DressingWay way;
  std::size_t number = 0;   ///< of the way, in dressing_ways()
  double seam_gap = 0;      ///< m, the widest when the seams were joined
  Effort effort;            ///< what is left of it
  int bared_shoulders = 0;  ///< that it was meant to lie on: straps hang on the arms
};

/// Who looks on: called now and then with where each garment vertex is, m. May be empty.
using ShapeWatch = std::function<void(std::span<const Vec3>)>;

/// One try, which is broken off before it parts what crosses where its effort is spent. Progress phase:
/// "dress".
Dressed dress(const sewing::Assembly& assembly, const Wearer& wearer, const DressingWay& way,
              const RunContext& context, const ShapeWatch& watch = {}, Effort effort = Effort());

/// Parts what still crosses in a shape whose seams are shut, and judges it.
void finish(const sewing::Assembly& assembly, const Wearer& wearer, Dressed& dressed);

/// Whether two ways are one for this garment: one without wide skirts has nothing to fold.
bool same_way(const sewing::Assembly& assembly, const Wearer& wearer, const DressingWay& a,
              const DressingWay& b);

/// The ways, in the order in which they are worth trying.
const std::vector<DressingWay>& dressing_ways();

}  // namespace toile::dressing
