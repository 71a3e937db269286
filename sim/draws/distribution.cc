#include "sim/draws/distribution.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/normal.h"

namespace dockyard {
namespace {

/// What a normal has below min, between min and max, and above max. Small shares keep all digits,
/// which 1 - share would lose.
struct Shares {
  double below, inside, above;
};

Shares SharesOf(const Normal& normal) {
  DOCKYARD_CHECK(std::isfinite(normal.mean) && std::isfinite(normal.std) && normal.std > 0.0);
  DOCKYARD_CHECK(normal.min <= normal.max);
  const double low = (normal.min - normal.mean) / normal.std;
  const double high = (normal.max - normal.mean) / normal.std;
  const double below = NormalShare(low), above = NormalShare(-high);
  const double inside = low > 0.0 ? NormalShare(-low) - above : NormalShare(high) - below;
  return {below, inside, above};
}

// The quantile is taken in the tail that is smaller at the value, where the share has its digits.
double QuantileOf(const Normal& normal, double u) {
  const Shares shares = SharesOf(normal);
  DOCKYARD_CHECK(shares.inside >= kLeastShareLeft);
  const double below = shares.below + u * shares.inside;
  const double z = below <= 0.5 ? NormalQuantile(below)
                                : -NormalQuantile(shares.above + (1.0 - u) * shares.inside);
  return std::clamp(normal.mean + normal.std * z, normal.min, normal.max);
}

double QuantileOf(const Uniform& uniform, double u) {
  DOCKYARD_CHECK(std::isfinite(uniform.min) && std::isfinite(uniform.max));
  DOCKYARD_CHECK(uniform.min <= uniform.max);
  // Two products, as max - min may overflow.
  return std::clamp((1.0 - u) * uniform.min + u * uniform.max, uniform.min, uniform.max);
}

double QuantileOf(const LogUniform& uniform, double u) {
  DOCKYARD_CHECK(uniform.min > 0.0 && std::isfinite(uniform.max) && uniform.min <= uniform.max);
  const double low = std::log(uniform.min), high = std::log(uniform.max);
  return std::clamp(std::exp(low + u * (high - low)), uniform.min, uniform.max);
}

}  // namespace

double ShareLeft(const Normal& normal) { return SharesOf(normal).inside; }

double Quantile(const Distribution& distribution, double u) {
  DOCKYARD_CHECK(u > 0.0 && u < 1.0);
  return std::visit([u](const auto& each) { return QuantileOf(each, u); }, distribution);
}

std::size_t Pick(const Discrete& discrete, double u) {
  DOCKYARD_CHECK(u > 0.0 && u < 1.0);
  double total = 0.0;
  for (const double weight : discrete.weights) {
    DOCKYARD_CHECK(weight >= 0.0);
    total += weight;
  }
  DOCKYARD_CHECK(total > 0.0 && std::isfinite(total));
  // u < 1 keeps u * total below the last sum, which is the total: the loop ends in the list.
  std::size_t place = 0;
  double sum = discrete.weights[0];
  while (u * total >= sum) sum += discrete.weights[++place];
  return place;
}

}  // namespace dockyard
