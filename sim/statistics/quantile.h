// Quantiles of a sample.
#pragma once

#include <vector>

namespace dockyard {

/// Linear between the order statistics, the smallest value at 0 and the largest at 1: definition 7
/// of Hyndman and Fan (Am. Stat. 50, 1996), the default of R, NumPy and spreadsheets.
/// @param sorted  rising, at least one value
/// @param share   in [0, 1]
double SampleQuantile(const std::vector<double>& sorted, double share);

}  // namespace dockyard
