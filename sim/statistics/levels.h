// How much of a measure's variation goes with the levels of a factor, such as the soil's name. No
// order of the levels is needed, so a factor of numbers, cut into levels, shows relations that rise
// and fall as well.
#pragma once

#include <vector>

namespace dockyard {

struct LevelEffect {
  /// Share of the sum of squares that lies between the levels (Pearson's correlation ratio, eta^2).
  /// Of values 0 and 1 it is the square of Cramer's V.
  double eta_squared = 0.0;
  /// The same corrected for chance, never below 0: about 0 on the mean where the levels do not
  /// matter (epsilon^2: Kelley, Proc. Natl. Acad. Sci. 21, 1935).
  double epsilon_squared = 0.0;
  /// The chance of so large an eta^2, or a larger, if the levels did not matter: (n - 1) eta^2
  /// against the chi-square distribution. Of ranks this is the test of Kruskal and Wallis (J. Am.
  /// Stat. Assoc. 47, 1952), equal values included; of values 0 and 1 it is Pearson's test, but for
  /// n - 1 in place of n. For five runs or more at each level.
  double p_value = 1.0;
};

/// NaN in all: the values or the levels do not vary, or no level has two runs.
/// @param levels  of each run, >= 0
/// @param values  of each run, such as ranks, or 0 and 1; no NaN
LevelEffect EffectOfLevels(const std::vector<int>& levels, const std::vector<double>& values);

/// Cuts ranks into so many levels of about the same number of runs. Equal ranks share a level, so
/// there may be fewer.
std::vector<int> LevelsOfRanks(const std::vector<double>& ranks, int count);

}  // namespace dockyard
