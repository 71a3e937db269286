// Intervals of a share that is known from a count.
#pragma once

namespace dockyard {

struct Interval {
  double low = 0.0, high = 1.0;
};

/// Exact interval of a binomial share (Clopper and Pearson, Biometrika 26, 1934): the shares p for
/// which neither P(X >= successes) nor P(X <= successes) falls below (1 - confidence) / 2.
/// @param trials  0 gives [0, 1]
Interval ClopperPearson(int successes, int trials, double confidence = 0.95);

}  // namespace dockyard
