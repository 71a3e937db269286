// Intervals of a share that is known from a count.
//
// A confidence is in (0, 1). Counts: 0 <= successes <= trials. Without trials every interval is
// [0, 1]: nothing is known.
#pragma once

namespace dockyard {

struct Interval {
  double low = 0.0, high = 1.0;
};

/// A value with its interval.
struct Estimate {
  double value = 0.0;
  Interval interval;
};

/// Exact interval of a binomial share (Clopper and Pearson, Biometrika 26, 1934): the shares p for
/// which neither P(X >= successes) nor P(X <= successes) falls below (1 - confidence) / 2.
Interval ClopperPearson(int successes, int trials, double confidence = 0.95);

/// Score interval (Wilson, J. Am. Stat. Assoc. 22, 1927). Shorter than the exact one; it holds the
/// confidence in the mean over all shares, not at each.
Interval Wilson(int successes, int trials, double confidence = 0.95);

/// One-sided bounds of Clopper and Pearson: the share is at least LowerBound with the confidence,
/// and, as another statement, at most UpperBound.
double LowerBound(int successes, int trials, double confidence);
double UpperBound(int successes, int trials, double confidence);

/// The z with P(-z < Z < z) = confidence of a standard normal Z: 1.96 for 0.95.
double NormalDeviate(double confidence);

}  // namespace dockyard
