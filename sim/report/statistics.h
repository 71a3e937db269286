// Rates with their uncertainty: a share of a few dozen runs means little without its interval.
#pragma once

#include <string>

namespace dockyard {

struct Interval {
  double low = 0.0, high = 1.0;
};

/// Exact interval of a binomial share (Clopper and Pearson, Biometrika 26, 1934): the shares p for
/// which neither P(X >= successes) nor P(X <= successes) falls below (1 - confidence) / 2.
/// @param trials  0 gives [0, 1]
Interval ClopperPearson(int successes, int trials, double confidence = 0.95);

/// "31/40 (78 %, 62-89 %)", with the 95 % interval; "0/0" without trials.
std::string RateText(int successes, int trials);
/// "docked 31/40 (78 %, 62-89 %)"
std::string BriefRate(int docked, int runs);
/// Four figures: "0.2103", "4e-05", "nan".
std::string BriefNumber(double value);

}  // namespace dockyard
