#include "sim/rigid/tree_factor.h"

#include <utility>

#include "sim/rigid/four_doubles.h"

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

// The first four of a row's numbers at once, then the other two.
DOCKYARD_FOUR_AT_ONCE void TreeFactor::SolveSix(double* x) const {
  const auto IsZero = [](const double* at) {
    return at[0] == 0.0 && at[1] == 0.0 && at[2] == 0.0 && at[3] == 0.0 && at[4] == 0.0 &&
           at[5] == 0.0;
  };
  FourDoubles four, other;
  for (int i = size() - 1; i >= 0; --i) {
    double* const at = x + 6 * i;
    if (IsZero(at)) continue;  // as are joints that do not move the link
    const double* const own = row(i);
    const double e = at[4], f = at[5];
    Load(at, four);
    ForInwards(i, [&](int j) {
      double* const to = x + 6 * j;
      Load(to, other);
      Store(other - own[j] * four, to);
      to[4] -= own[j] * e;
      to[5] -= own[j] * f;
    });
    Store(four * own[i], at);
    at[4] = e * own[i];
    at[5] = f * own[i];
  }
  for (int i = 0; i < size(); ++i) {
    const double* const own = row(i);
    double* const at = x + 6 * i;
    double e = at[4], f = at[5];
    Load(at, four);
    ForInwards(i, [&](int j) {
      const double* const from = x + 6 * j;
      Load(from, other);
      four -= own[j] * other;
      e -= own[j] * from[4];
      f -= own[j] * from[5];
    });
    Store(four, at);
    at[4] = e;
    at[5] = f;
  }
}

}  // namespace dockyard
