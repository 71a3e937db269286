// Internal to the vision room.
#pragma once

#include <Eigen/Cholesky>

namespace dockyard {

/// Levenberg-Marquardt, until a step wins less than that share of 1 + cost.
/// @param problem  Cost(at) and Cost(at, &equations); A step = -b in these, and Moved(at, step)
template <class Equations, class Problem, class Estimate>
Estimate Descend(Problem& problem, Estimate at, int max_iterations, double least_gain) {
  double damping = 1e-3;
  Equations equations;
  double cost = problem.Cost(at, &equations);
  for (int i = 0; i < max_iterations; ++i) {
    bool better = false;
    double gain = 0.0;
    while (!better && damping < 1e8) {
      auto damped = equations.A;
      damped.diagonal() *= 1.0 + damping;
      damped.diagonal().array() += 1e-12;
      const decltype(equations.b) step = -damped.ldlt().solve(equations.b);
      if (!step.allFinite()) return at;
      const Estimate moved = Moved(at, step);
      const double moved_cost = problem.Cost(moved);
      better = moved_cost < cost;
      damping *= better ? 0.1 : 8.0;
      if (!better) continue;
      gain = cost - moved_cost;
      at = moved;
      cost = moved_cost;
    }
    if (!better || gain < least_gain * (1.0 + cost)) break;
    problem.Cost(at, &equations);
  }
  return at;
}

}  // namespace dockyard
