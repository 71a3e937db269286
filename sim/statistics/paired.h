// Two controllers on the same runs: is one better, and by how much?
//
// Both meet the same seeds, so runs are compared in pairs. Pairs in which both succeed or both fail
// tell nothing about which one is better.
#pragma once

#include "sim/statistics/intervals.h"

namespace dockyard {

/// Pairs by who succeeded. Each count >= 0, their sum an int.
struct PairedCounts {
  int both = 0, only_a = 0, only_b = 0, neither = 0;
};

/// McNemar's exact test, two-sided: 2 P(X <= the smaller; only_a + only_b, 1/2), at most 1. It
/// is the chance of counts as unequal as these, or more, if A and B were equally good. Never too
/// small, usually too large (Fagerland, Lydersen and Laake, BMC Med. Res. Methodol. 13:91, 2013,
/// eq. 1). 1 without pairs that differ.
double McNemarExact(int only_a, int only_b);

/// The same with half the chance of the observed counts (eq. 2 there; 1 minus that half when both
/// are equal). Near the nominal level, which it exceeded in none of their 9595 cases.
/// 1 without pairs that differ.
double McNemarMidP(int only_a, int only_b);

/// McNemar's exact test against one side: the chance of as many or more pairs in which B alone
/// succeeds, P(X >= only_b; only_a + only_b, 1/2), if A were as good as B. Small: A is worse.
double ChanceOfAWorse(int only_a, int only_b);

/// Share of A's successes less that of B's, with the interval of Newcombe's method 10 (Stat. Med.
/// 17, 2635, 1998): two Wilson intervals, joined with the correlation of the pairs.
/// Without pairs the value is NaN and the interval [-1, 1].
Estimate PairedDifference(const PairedCounts& counts, double confidence = 0.95);

}  // namespace dockyard
