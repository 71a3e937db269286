// Several tests at once: p values and confidences that hold for all of them together.
#pragma once

#include <vector>

namespace dockyard {

/// Holm's step-down adjustment (Scand. J. Stat. 6, 1979): rejecting every test whose adjusted p is
/// at most alpha rejects any true hypothesis with a chance of at most alpha, however the tests
/// depend on each other. The i-th smallest p of m is taken times m - i + 1, never below the one
/// before it and at most 1.
/// @param p  in [0, 1]; a NaN is no test, it stays NaN and is not counted
std::vector<double> HolmAdjusted(const std::vector<double>& p);

/// The confidence of each of `count` statements for which all hold together with the confidence
/// that is asked for, however they depend on each other: 1 - (1 - confidence) / count (Bonferroni's
/// inequality; Dunn, J. Am. Stat. Assoc. 56, 1961).
/// @param count  at least 1
double ConfidenceOfEach(double confidence, int count);

}  // namespace dockyard
