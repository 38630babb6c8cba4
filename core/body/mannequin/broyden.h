#pragma once
// Finding what a function of several numbers must be given so that nothing is off, when only its values are
// known, and each costs a body to make.

#include <cstddef>
#include <vector>

namespace toile::mannequin {

/// What is known of how steps move what is off: an estimate of the Jacobian's inverse, bettered after every
/// step (C. G. Broyden, "A class of methods for solving nonlinear simultaneous equations", Mathematics of
/// Computation 19, 1965, the first of the two). Steps and what is off are vectors of one length n.
class Broyden {
 public:
  /// Whether nothing is known, not even n.
  bool empty() const { return size_ == 0; }
  void clear() { *this = {}; }

  /// Begins as if each number moved its own value only, one to one.
  void begin(std::size_t n);

  /// The step that would bring `off` to nothing, times `share`, a power of two.
  std::vector<double> step(const std::vector<double>& off, double share) const;

  /// Takes in that `step` moved what is off from `before` to `after`. What moved next to nothing teaches
  /// nothing: dividing by it would make the estimate wild.
  void learn(const std::vector<double>& step, const std::vector<double>& before,
             const std::vector<double>& after);

 private:
  std::size_t size_ = 0;
  std::vector<double> inverse_;  ///< n × n, column by column
};

}  // namespace toile::mannequin
