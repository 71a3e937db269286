// What a count of successes says about the count of runs that are still to come.
#pragma once

namespace dockyard {

/// Counts from low to high, both of them in.
struct CountInterval {
  int low = 0, high = 0;
  bool Holds(int count) const { return low <= count && count <= high; }
};

/// Exact prediction interval of the successes of `future` trials, given `successes` of `trials`
/// with the same chance (Thatcher, J. R. Stat. Soc. B 26, 1964). Given the sum of both counts,
/// either is hypergeometric whatever the chance. The interval holds the counts whose tails, to
/// their own side and themselves in, exceed (1 - confidence) / 2 each: those that Fisher's exact
/// test of "the same chance" does not refuse. So it covers with at least the confidence at every
/// chance, the uncertainty of `successes` included. Where each future trial has one chance of its
/// own and an equal number of the known trials shares it, the counts vary less (Hoeffding, Ann.
/// Math. Stat. 27, 1956), and the interval stays on the safe side.
/// Counts: 0 <= successes <= trials, future >= 0; a confidence is in (0, 1).
CountInterval PredictCount(int successes, int trials, int future, double confidence = 0.95);

/// The chance of a future count at least as far to its side, both sides taken, at most 1: twice
/// Fisher's smaller one-sided p. The interval of a confidence C holds the counts above 1 - C.
double PredictionP(int successes, int trials, int count, int future);

}  // namespace dockyard
