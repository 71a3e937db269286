// Tests of goodness of fit, all at the significance 0.001: of a thousand right programs one would
// fail. The seeds are fixed, so that a test which passes does so for ever.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace dockyard {

/// Largest distance of the sample's distribution function from `share`, times the root of the
/// sample's size.
template <class Share>
double KolmogorovSmirnov(std::vector<double> sample, const Share& share) {
  std::sort(sample.begin(), sample.end());
  const auto size = static_cast<double>(sample.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double p = share(sample[i]), rank = static_cast<double>(i);
    largest = std::max({largest, p - rank / size, (rank + 1.0) / size - p});
  }
  return largest * std::sqrt(size);
}
/// Its limit for large samples: 2 exp(-2 x^2) = 0.001.
inline constexpr double kKolmogorovSmirnovBound = 1.9495;

/// Of counts that should be in proportion to `weights`.
inline double ChiSquare(const std::vector<int>& counts, const std::vector<double>& weights) {
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double expected = all * weights[i] / total;
    sum += (counts[i] - expected) * (counts[i] - expected) / expected;
  }
  return sum;
}
inline double ChiSquare(const std::vector<int>& counts) {
  return ChiSquare(counts, std::vector<double>(counts.size(), 1.0));
}
/// Its quantile 0.999 by the cube root of Wilson and Hilferty (1931), good to 1 % from 3 degrees
/// on.
inline double ChiSquareBound(double freedom) {
  return freedom *
         std::pow(1.0 - 2.0 / (9.0 * freedom) + 3.0902 * std::sqrt(2.0 / (9.0 * freedom)), 3);
}

/// Chi-square of pairs of numbers in [0, 1) over `cells` x `cells` equal squares.
class PairCounts {
 public:
  explicit PairCounts(int cells) : cells_(cells), counts_(cells * cells) {}
  void Add(double a, double b) {
    ++counts_[static_cast<int>(a * cells_) * cells_ + static_cast<int>(b * cells_)];
  }
  double ChiSquare() const { return dockyard::ChiSquare(counts_); }

 private:
  int cells_;
  std::vector<int> counts_;
};

}  // namespace dockyard
