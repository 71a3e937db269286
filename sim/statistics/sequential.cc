#include "sim/statistics/sequential.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "controller/base/check.h"

namespace dockyard {
namespace {

/// Tests that go on, by their number of failures so far: chance[f] for f in [low, high].
struct Going {
  std::vector<double> chance{1.0};
  int low = 0, high = 0;

  double& operator[](int failures) { return chance[static_cast<std::size_t>(failures)]; }
  bool Any() const { return low <= high; }
  double Sum() {
    double sum = 0.0;
    for (int f = low; f <= high; ++f) sum += (*this)[f];
    return sum;
  }
  void RunOnce(double reliability) {
    chance.resize(static_cast<std::size_t>(++high) + 1);
    (*this)[high] = 0.0;  // also where tests were rejected before
    for (int f = high; f > low; --f) {
      (*this)[f] = (*this)[f] * reliability + (*this)[f - 1] * (1.0 - reliability);
    }
    (*this)[low] *= reliability;
  }
};

}  // namespace

SequentialPlan WaldPlan(const SequentialAims& aims) {
  const double alpha = 1.0 - aims.confidence, beta = 1.0 - aims.power;
  const double r = aims.reliability, r1 = aims.design_reliability;
  DOCKYARD_CHECK(r > 0.0 && r < r1 && r1 < 1.0);
  DOCKYARD_CHECK(alpha > 0.0 && alpha < 1.0 && beta > 0.0 && alpha + beta < 1.0);
  DOCKYARD_CHECK(aims.max_runs >= 1);
  SequentialPlan plan;
  plan.aims = aims;
  plan.per_success = std::log(r1 / r);
  plan.per_failure = std::log((1.0 - r1) / (1.0 - r));
  plan.accept_at = std::log((1.0 - beta) / alpha);
  plan.reject_at = std::log(beta / (1.0 - alpha));
  return plan;
}

SequentialPlan PlanSequential(const SequentialAims& aims) {
  SequentialPlan plan = WaldPlan(aims);
  const double alpha = 1.0 - aims.confidence;
  const auto holds = [&] { return ExactOperation(plan, aims.reliability).accept <= alpha; };
  if (holds()) return plan;
  // A quarter of a success is fine enough: a finer bound would stop the same tests.
  double too_low = plan.accept_at, high_enough = -std::log(alpha);
  while (high_enough - too_low > 0.25 * plan.per_success) {
    plan.accept_at = 0.5 * (too_low + high_enough);
    (holds() ? high_enough : too_low) = plan.accept_at;
  }
  plan.accept_at = high_enough;
  return plan;
}

SequentialState StateAfter(const SequentialPlan& plan, int trials, int failures) {
  DOCKYARD_CHECK(failures >= 0 && failures <= trials);
  const double ratio = (trials - failures) * plan.per_success + failures * plan.per_failure;
  if (ratio >= plan.accept_at) return SequentialState::kAccepted;
  if (ratio <= plan.reject_at) return SequentialState::kRejected;
  return trials < plan.aims.max_runs ? SequentialState::kContinue : SequentialState::kUndecided;
}

void FollowRun(const SequentialPlan& plan, bool failed, SequentialEnd& end) {
  if (end.state != SequentialState::kContinue) return;
  ++end.trials;
  end.failures += failed;
  end.state = StateAfter(plan, end.trials, end.failures);
}

SequentialOperation ExactOperation(const SequentialPlan& plan, double true_reliability) {
  DOCKYARD_CHECK(true_reliability >= 0.0 && true_reliability <= 1.0);
  SequentialOperation operation;
  Going going;
  for (int trials = 1; trials <= plan.aims.max_runs; ++trials) {
    const double sum = going.Sum();
    if (sum < 1e-18) break;  // as good as ended; smaller numbers only take time
    operation.mean_runs += sum;
    going.RunOnce(true_reliability);
    // L falls with the failures: few accept, many reject.
    while (going.Any() && StateAfter(plan, trials, going.low) == SequentialState::kAccepted) {
      operation.accept += going[going.low++];
    }
    while (going.Any() && StateAfter(plan, trials, going.high) == SequentialState::kRejected) {
      operation.reject += going[going.high--];
    }
  }
  operation.undecided = going.Sum();
  return operation;
}

}  // namespace dockyard
