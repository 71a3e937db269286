#include "sim/statistics/acceptance.h"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>

#include "controller/base/check.h"
#include "sim/statistics/intervals.h"

namespace dockyard {
namespace {

// Rounding of 1 - C must not decide a tie such as R = 0.2, C = 0.8.
constexpr double kTie = 1e-12;

constexpr std::int64_t kMostRuns = std::int64_t{1} << 53;  // a double counts no further

void CheckPromises(double reliability, double confidence) {
  DOCKYARD_CHECK(reliability > 0.0 && reliability <= 1.0);
  DOCKYARD_CHECK(confidence >= 0.5 && confidence < 1.0);
}

/// P(X <= failures) among the trials of a system with that reliability.
double ChanceOfAtMost(std::int64_t failures, std::int64_t trials, double reliability) {
  if (failures >= trials) return 1.0;
  return boost::math::ibeta(double(trials - failures), failures + 1.0, reliability);
}

/// P(X >= failures).
double ChanceOfAtLeast(std::int64_t failures, std::int64_t trials, double reliability) {
  if (failures == 0) return 1.0;
  return boost::math::ibetac(trials - failures + 1.0, double(failures), reliability);
}

bool ShowsIt(std::int64_t failures, std::int64_t trials, double reliability, double confidence) {
  return ChanceOfAtMost(failures, trials, reliability) <= (1.0 - confidence) * (1.0 + kTie);
}

bool RefutesIt(std::int64_t failures, std::int64_t trials, double reliability, double confidence) {
  return ChanceOfAtLeast(failures, trials, reliability) < (1.0 - confidence) * (1.0 - kTie);
}

}  // namespace

const char* NameOf(AcceptanceVerdict verdict) {
  switch (verdict) {
    case AcceptanceVerdict::kAccepted:
      return "accepted";
    case AcceptanceVerdict::kNotAccepted:
      return "not accepted";
    case AcceptanceVerdict::kUndecided:
      break;
  }
  return "undecided";
}

Acceptance JudgeAcceptance(int trials, int failures, double reliability, double confidence) {
  CheckPromises(reliability, confidence);
  DOCKYARD_CHECK(failures >= 0 && failures <= trials);
  Acceptance judged;
  judged.lower = LowerBound(trials - failures, trials, confidence);
  judged.upper = UpperBound(trials - failures, trials, confidence);
  if (ShowsIt(failures, trials, reliability, confidence)) {
    judged.verdict = AcceptanceVerdict::kAccepted;
    judged.further_runs = 0;
  } else if (RefutesIt(failures, trials, reliability, confidence)) {
    judged.verdict = AcceptanceVerdict::kNotAccepted;
  } else if (const auto needed = RunsNeeded(reliability, confidence, failures)) {
    judged.further_runs = *needed - trials;
  }
  return judged;
}

std::optional<std::int64_t> RunsNeeded(double reliability, double confidence, int failures) {
  CheckPromises(reliability, confidence);
  DOCKYARD_CHECK(failures >= 0);
  // The chance falls with each run that is added, so the first number that is enough is bisected.
  std::int64_t too_few = failures, enough = std::int64_t{failures} + 1;
  while (!ShowsIt(failures, enough, reliability, confidence)) {
    if (enough == kMostRuns) return std::nullopt;
    too_few = enough;
    enough = std::min(2 * enough, kMostRuns);
  }
  while (enough - too_few > 1) {
    const std::int64_t middle = too_few + (enough - too_few) / 2;
    (ShowsIt(failures, middle, reliability, confidence) ? enough : too_few) = middle;
  }
  return enough;
}

}  // namespace dockyard
