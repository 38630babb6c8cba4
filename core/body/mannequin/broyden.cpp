#include "core/body/mannequin/broyden.h"

#include <Eigen/Core>

namespace toile::mannequin {
namespace {

constexpr double kLeastEffect = 0.25;   // of a step on what is off, to learn from it
constexpr double kLeastSquares = 1e-8;  // of a step, likewise

using Vector = Eigen::Map<const Eigen::VectorXd>;

Eigen::Index index_of(std::size_t n) { return static_cast<Eigen::Index>(n); }
Vector seen(const std::vector<double>& v) { return {v.data(), index_of(v.size())}; }

}  // namespace

void Broyden::begin(std::size_t n) {
  size_ = n;
  inverse_.resize(n * n);
  Eigen::Map<Eigen::MatrixXd>(inverse_.data(), index_of(n), index_of(n)).setIdentity();
}

std::vector<double> Broyden::step(const std::vector<double>& off, double share) const {
  const Eigen::Map<const Eigen::MatrixXd> inverse(inverse_.data(), index_of(size_), index_of(size_));
  std::vector<double> out(size_);
  Eigen::Map<Eigen::VectorXd>(out.data(), index_of(size_)) = -share * (inverse * seen(off));
  return out;
}

void Broyden::learn(const std::vector<double>& step, const std::vector<double>& before,
                    const std::vector<double>& after) {
  Eigen::Map<Eigen::MatrixXd> inverse(inverse_.data(), index_of(size_), index_of(size_));
  const Vector s = seen(step);
  const Eigen::VectorXd effect = inverse * (seen(after) - seen(before));  // the step that was to be expected
  const double weight = s.dot(effect), squares = s.dot(s);
  if (!(weight > kLeastEffect * squares) || !(squares > kLeastSquares)) return;
  // The rank-one change after which that effect would have told this step (Sherman and Morrison's formula).
  const Eigen::RowVectorXd by_step = s.transpose() * inverse;
  inverse += (s - effect) * by_step / weight;
}

}  // namespace toile::mannequin
