// Factor of a tree's inertia, as sparse as the tree: M = L^T D L from the outermost joints inwards
// (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 6.5). Joints on different branches
// do not meet in it, so that a step costs less than by a dense factor.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace dockyard {

class TreeFactor {
 public:
  /// The first `of_base` speeds are the base's, which all others move with. inwards: of each speed
  /// the next joint's inwards; below of_base: there is none.
  TreeFactor(int of_base, std::vector<int> inwards);

  /// Rows of the matrix. Compute needs those numbers of the lower half that are not zero by the
  /// tree's shape.
  double* row(int i) { return numbers_.data() + Place(i) * Place(size()); }
  int size() const { return static_cast<int>(inwards_.size()); }
  /// Puts the factor in the matrix's place.
  void Compute();
  void Solve(double* x) const;
  /// For six right sides at once, which lie speed by speed.
  void SolveSix(double* x) const;

 private:
  static std::size_t Place(int i) { return static_cast<std::size_t>(i); }
  const double* row(int i) const { return numbers_.data() + Place(i) * Place(size()); }
  /// For each speed that moves the joint of this one.
  template <class F>
  void ForInwards(int i, const F& visit) const {
    for (int j = inwards_[Place(i)]; j >= of_base_; j = inwards_[Place(j)]) visit(j);
    for (int j = 0, most = std::min(i, of_base_); j < most; ++j) visit(j);
  }

  int of_base_ = 0;
  std::vector<int> inwards_;
  std::vector<double> numbers_;  // row by row; on the diagonal of the factor 1 / D
};

}  // namespace dockyard
