#pragma once
// Sleeves that are cut on: parts of the trunk's pieces that reach far beyond the armpits and are meant for
// the arms.

#include <span>
#include <vector>

#include "core/body/measure/figure.h"
#include "core/dressing/staging.h"
#include "core/sewing/assembly.h"

namespace toile::dressing {

/// Whether the piece (a panel's index) lies on the shoulders and reaches far beyond them at their height.
bool has_cut_on_sleeves(const sewing::Assembly& assembly, std::size_t piece,
                        const measure::BodyFigure& figure);

/// Lays what of pieces for the trunk reaches beyond the armpits along the arms: their middle line on the
/// arm's, lengths along it kept, heights across it too. `x`: one position a garment vertex, m.
void lay_along_arms(const sewing::Assembly& assembly, std::span<const Covers> covers,
                    const measure::BodyFigure& figure, std::vector<Vec3>& x);

/// While it is sewn: cloth that was laid along an arm would turn back to where it was drawn, off the arm.
class KeptOnArms {
 public:
  /// `x`: where lay_along_arms() has laid it.
  KeptOnArms(const sewing::Assembly& assembly, std::span<const Covers> covers,
             const measure::BodyFigure& figure, std::span<const Vec3> x);

  /// Takes back how each sleeve as a whole has turned and moved off its arm since `before`, seen from
  /// before.
  void keep(std::span<const Vec3> before, std::vector<Vec3>& x) const;

 private:
  struct Sleeve {
    std::vector<Index> vertices;
    Vec3 root, along, across;
  };
  std::vector<Sleeve> sleeves_;
};

}  // namespace toile::dressing
