// A test of reliability that looks after each run and stops as soon as it may (Wald, Sequential
// Analysis, 1947: the sequential probability ratio test).
//
// Two reliabilities stand against each other: R, which is to be shown, and R1 > R, for which the
// system is designed. Each run adds to L = ln(likelihood at R1 / likelihood at R):
//     a success ln(R1 / R) > 0, a failure ln((1 - R1) / (1 - R)) < 0.
// A high L speaks for R1. The risks are
//     alpha = 1 - confidence: the chance to accept a system that is only at R (consumer's risk),
//     beta = 1 - power: the chance to reject a system that is at R1 (producer's risk).
// The test accepts at L >= ln((1 - beta) / alpha) and rejects at L <= ln(beta / (1 - alpha)). The
// chance to accept grows with the true reliability, so alpha bounds it for all systems below R too.
// Plans for the inspection of lots (NIST/SEMATECH 6.2.6) take the good lot as their hypothesis:
// their alpha is beta here, and their beta is alpha.
#pragma once

namespace dockyard {

struct SequentialAims {
  double reliability = 0.95;         // R, in (0, R1)
  double confidence = 0.95;          // in (0, 1)
  double design_reliability = 0.99;  // R1, in (R, 1)
  double power = 0.9;                // in (0, 1), above 1 - confidence
  int max_runs = 1000;               // >= 1; then the test ends undecided
};

struct SequentialPlan {
  SequentialAims aims;
  double per_success = 0.0, per_failure = 0.0;  // what a run adds to L
  double accept_at = 0.0, reject_at = 0.0;      // bounds of L
};

/// Wald's plan. His bounds hold both risks only nearly: the chance to accept at R may exceed alpha,
/// up to alpha / (1 - beta), because L jumps past the bound of rejection but hardly past the other.
/// The end at max_runs only takes from both chances, to accept and to reject.
SequentialPlan WaldPlan(const SequentialAims& aims);

/// Wald's plan with its bound of acceptance raised, where needed, until the exact chance to accept
/// at R is at most 1 - confidence. The bound stays below ln(1 / alpha): from there on Ville's
/// inequality (1939) alone keeps the chance at alpha. The power that this and max_runs cost is not
/// made up for; ExactOperation tells what is left. Takes a dozen calls of ExactOperation.
SequentialPlan PlanSequential(const SequentialAims& aims);

enum class SequentialState { kContinue, kAccepted, kRejected, kUndecided };

/// What the plan says after so many runs, if it said kContinue after each run before. Ask after
/// every run, in the order of the runs, and stop at the first decision: a look after every tenth
/// run, or in the order in which workers finish, is another test with other risks.
SequentialState StateAfter(const SequentialPlan& plan, int trials, int failures);

/// Where a test ended, or stands.
struct SequentialEnd {
  SequentialState state = SequentialState::kContinue;
  int trials = 0, failures = 0;
};

/// Takes the next run, in the order of the runs. A run after the end changes nothing.
void FollowRun(const SequentialPlan& plan, bool failed, SequentialEnd& end);

/// How the test fares with a system of that reliability.
struct SequentialOperation {
  double accept = 0.0, reject = 0.0, undecided = 0.0;  // chances, of sum 1
  double mean_runs = 0.0;
};

/// Exact but for rounding, by recursion over (trials, failures). Time grows as max_runs times the
/// number of failures between the bounds; 10^6 runs take about 20 ms.
/// @param true_reliability  in [0, 1]
SequentialOperation ExactOperation(const SequentialPlan& plan, double true_reliability);

}  // namespace dockyard
