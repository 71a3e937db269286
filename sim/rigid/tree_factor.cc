#include "sim/rigid/tree_factor.h"

#include <utility>

namespace dockyard {

TreeFactor::TreeFactor(int of_base, std::vector<int> inwards)
    : of_base_(of_base),
      inwards_(std::move(inwards)),
      numbers_(inwards_.size() * inwards_.size()) {}

void TreeFactor::Compute() {
  for (int k = size() - 1; k >= 0; --k) {
    double* const own = row(k);
    const double inverse = 1.0 / own[k];
    own[k] = inverse;
    // Each row inwards loses what this joint takes.
    const auto Take = [&](int i) {
      double* const other = row(i);
      const double share = own[i] * inverse;
      other[i] -= share * own[i];
      ForInwards(i, [&](int j) { other[j] -= share * own[j]; });
    };
    ForInwards(k, Take);
    ForInwards(k, [&](int i) { own[i] *= inverse; });
  }
}

void TreeFactor::Solve(double* x) const {
  for (int i = size() - 1; i >= 0; --i) {
    const double* const own = row(i);
    const double at = x[i];
    ForInwards(i, [&](int j) { x[j] -= own[j] * at; });
    x[i] = at * own[i];
  }
  for (int i = 0; i < size(); ++i) {
    const double* const own = row(i);
    double at = x[i];
    ForInwards(i, [&](int j) { at -= own[j] * x[j]; });
    x[i] = at;
  }
}

void TreeFactor::SolveThree(double* x) const {
  for (int i = size() - 1; i >= 0; --i) {
    const double* const own = row(i);
    double* const at = x + 3 * i;
    const double a = at[0], b = at[1], c = at[2];
    ForInwards(i, [&](int j) {
      x[3 * j] -= own[j] * a;
      x[3 * j + 1] -= own[j] * b;
      x[3 * j + 2] -= own[j] * c;
    });
    for (int column = 0; column < 3; ++column) at[column] *= own[i];
  }
  for (int i = 0; i < size(); ++i) {
    const double* const own = row(i);
    double* const at = x + 3 * i;
    double a = at[0], b = at[1], c = at[2];
    ForInwards(i, [&](int j) {
      a -= own[j] * x[3 * j];
      b -= own[j] * x[3 * j + 1];
      c -= own[j] * x[3 * j + 2];
    });
    at[0] = a, at[1] = b, at[2] = c;
  }
}

}  // namespace dockyard
