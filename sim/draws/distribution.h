// Distributions of a campaign's numbers, each by the inverse of its distribution function: one
// uniform number u in the open interval (0, 1) gives one value, whatever design made u.
#pragma once

#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

namespace dockyard {

/// Normal with this mean and standard deviation (> 0) before it is truncated to [min, max].
struct Normal {
  double mean = 0.0, std = 1.0;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};
/// Uniform in [min, max], min <= max, both finite.
struct Uniform {
  double min = 0.0, max = 1.0;
};
/// Its logarithm is uniform: 0 < min <= max, both finite.
struct LogUniform {
  double min = 1.0, max = 1.0;
};
/// Place i in a list with a chance in proportion to weights[i]: finite, >= 0, not all 0.
struct Discrete {
  std::vector<double> weights;
};

/// Distributions over the real numbers.
using Distribution = std::variant<Normal, Uniform, LogUniform>;

/// The share of the normal that [min, max] leaves.
double ShareLeft(const Normal& normal);
/// The least share that a truncation may leave: below it the smallest doubles lose their digits.
/// [min, max] may begin up to 36 standard deviations from the mean.
inline constexpr double kLeastShareLeft = 1e-290;

/// The value that a share u of the distribution lies below. Never outside of [min, max]; accurate
/// in both tails to a few 1e-16 standard deviations as far as u has the digits.
double Quantile(const Distribution& distribution, double u);
/// The place that u picks; places follow each other from u = 0 upwards. Never one of weight 0.
std::size_t Pick(const Discrete& discrete, double u);

}  // namespace dockyard
