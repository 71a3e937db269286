// Uniform numbers of several keys with wanted rank correlations, each uniform as before: a Gaussian
// copula.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace dockyard {

/// Wanted correlation of Spearman, in [-1, 1], of two different keys. It is that of the values as
/// well, since a quantile rises with its uniform number.
struct RankCorrelation {
  std::size_t first = 0, second = 0;
  double rank = 0.0;
};

class Correlation {
 public:
  /// Of keys 0 .. keys - 1; pairs without an entry are uncorrelated. Each pair has one entry at
  /// most. None if no normal numbers have such correlations: their matrix, 2 sin(pi rank / 6)
  /// (Pearson 1907), is not positive definite, or is so near it that a key all but follows from
  /// others, as with a rank of 1.
  static std::optional<Correlation> FromRanks(std::size_t keys,
                                              const std::vector<RankCorrelation>& ranks);

  /// Makes one run's uniform numbers, all in (0, 1), from independent ones. A key depends on those
  /// before it in the list only: a key without correlation and the first of a correlated group keep
  /// theirs bit for bit. The others are mixtures, which no longer hit each stratum of a Latin
  /// hypercube once, nor each interval of Sobol's points.
  void Apply(std::vector<double>& uniforms) const;

 private:
  /// One summand of a correlated normal number.
  struct Term {
    std::size_t key;
    double weight;
  };
  /// A key that changes, with all its summands.
  struct Row {
    std::size_t key;
    std::vector<Term> terms;
  };

  std::size_t keys_ = 0;
  std::vector<Row> rows_;  // from the last key to the first
};

}  // namespace dockyard
