// How strongly a measure rises or falls with a factor, by ranks: any monotone relation counts, not
// the straight line alone.
//
// A value that cannot be told is NaN, and so are the ends of its interval. An interval that cannot
// be told has NaN ends beside a value.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "sim/statistics/intervals.h"

namespace dockyard {

/// 1 for the smallest value; equal values share the mean of their ranks. All NaN if one value is.
std::vector<double> Ranks(const std::vector<double>& values);

/// Of each output with each input, in [-1, 1].
struct RankCorrelations {
  /// Spearman's. Its interval is Fisher's z with the variance (1 + r^2 / 2) / (n - 3) of Bonett and
  /// Wright (Psychometrika 65, 2000), good for |r| up to about 0.95 and few equal values. At r = -1
  /// and 1 that interval has no width, which says nothing.
  /// NaN: a column without two different values, a NaN in a column, n < 3. Interval NaN: n = 3.
  std::vector<std::vector<Estimate>> spearman;  // [output][input]
  /// Of what is left of both ranks after the linear regression on the ranks of all other inputs
  /// (Marino, Hogue, Ray and Kirschner, J. Theor. Biol. 254, 2008). The interval is Spearman's with
  /// n less the number of other inputs, as Fisher found for partial correlations (Metron 3, 1924).
  /// Other inputs that do not vary, or that repeat others, are not counted.
  /// NaN: the input or the output does not vary; the other inputs explain all ranks of either;
  /// fewer than three runs more than other inputs.
  std::vector<std::vector<Estimate>> partial;
};

/// Many columns at once, each given as its ranks and let go. n runs of c columns take n c^2 steps,
/// k inputs k^4 steps more, and memory for n c numbers of single precision, which holds ranks
/// exactly up to 8 million runs. NaN in an input makes all unknown, in an output those of this
/// output.
class RankTable {
 public:
  /// @param columns  the most that will be added
  RankTable(std::size_t rows, std::size_t columns);
  /// @param ranks  by Ranks
  void AddInput(const std::vector<double>& ranks);
  void AddOutput(const std::vector<double>& ranks);
  RankCorrelations Correlate(double confidence = 0.95) const;

 private:
  static constexpr Eigen::Index kLeftOut = -1;
  Eigen::Index Add(const std::vector<double>& ranks);
  Eigen::MatrixXd Condensed() const;

  Eigen::MatrixXf ranks_;                       // centred, by column; those that vary
  std::vector<double> scale_;                   // to the length 1
  std::vector<Eigen::Index> inputs_, outputs_;  // their columns, or kLeftOut
  bool known_ = true;
};

}  // namespace dockyard
