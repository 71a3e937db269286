// Judging a reliability by counting failures: the test of a fixed number of runs.
//
// The reliability R is the chance that one run succeeds. k failures in n runs show R at the
// confidence C when P(X <= k; n, 1 - R) <= 1 - C, so that a system below R passes with a chance of
// at most 1 - C. Without failures this is the success run n >= ln(1 - C) / ln R (ASTM F3499); with
// them it is the table of consumer's risk 1 - C in Hanson and Beard (NASA/TP-2010-216447).
//
// The confidence holds for a number of runs that is fixed before the first. Adding runs until the
// count passes raises the risk: with up to four failures a system at R = 0.99 exactly passes 0.99
// at 95 % with a chance of 12 %, not 5 %. A sequential test (sequential.h) may look after each run.
#pragma once

#include <cstdint>
#include <optional>

namespace dockyard {

enum class AcceptanceVerdict { kAccepted, kNotAccepted, kUndecided };

/// "accepted", "not accepted", "undecided"
const char* NameOf(AcceptanceVerdict verdict);

struct Acceptance {
  AcceptanceVerdict verdict = AcceptanceVerdict::kUndecided;
  /// One-sided bounds of Clopper and Pearson on the chance of success, each at the confidence.
  double lower = 0.0, upper = 1.0;
  /// Undecided: the fewest further runs that would be accepted if all succeeded; empty if no number
  /// is enough. Accepted: 0. Not accepted: empty.
  std::optional<std::int64_t> further_runs;
};

/// Accepted when the lower bound reaches the reliability, not accepted when the upper bound is
/// below it, else undecided.
/// @param failures     0 to trials
/// @param reliability  in (0, 1]; 1 is never accepted, and not accepted from the first failure on
/// @param confidence   in [0.5, 1): below, both bounds could be passed at once
Acceptance JudgeAcceptance(int trials, int failures, double reliability, double confidence);

/// The smallest number of runs that is accepted with so many failures; empty if no number up to
/// 2^53 is, as with a reliability of 1. Ranges as above, any number of failures >= 0.
std::optional<std::int64_t> RunsNeeded(double reliability, double confidence, int failures);

}  // namespace dockyard
