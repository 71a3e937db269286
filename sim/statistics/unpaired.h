// Two groups of runs that share no draws: is one better, and by how much?
#pragma once

#include "sim/statistics/intervals.h"

namespace dockyard {

/// Successes of two groups.
struct GroupCounts {
  int successes_a = 0, runs_a = 0, successes_b = 0, runs_b = 0;  // 0 <= successes <= runs
};

/// Fisher's exact test, two-sided: the chance, given both sums, of a table that is no more likely
/// than this one, if both groups had one success rate (Fisher, Statistical Methods for Research
/// Workers, 1934; the two sides as Freeman and Halton, Biometrika 38, 1951). 1 without runs in a
/// group.
double FisherExact(const GroupCounts& counts);

/// The same against one side: the chance of as few successes in A, or fewer. Small: A is worse.
double ChanceOfAWorseGroup(const GroupCounts& counts);

/// Share of A's successes less that of B's, with the interval of Newcombe's method 10 for
/// independent groups (Stat. Med. 17, 873, 1998): two Wilson intervals, joined. Without runs in a
/// group the value is NaN and the interval [-1, 1].
Estimate GroupDifference(const GroupCounts& counts, double confidence = 0.95);

}  // namespace dockyard
