// A campaign beside a kept one of the same file, such as with an earlier build: run by run on the
// same draws.
#pragma once

#include <vector>

#include "sim/log/record.h"
#include "sim/statistics/paired.h"

namespace dockyard {

struct BaselinePairs {
  PairedCounts counts;         // a: this campaign, b: the baseline
  int same_bits = 0;           // pairs with the same commands and true states all the way
  std::vector<int> lost, won;  // numbers of the runs that docked in the baseline alone, here alone
  // Runs that do not pair, by number: not in the other campaign, or there with another seed or
  // other labels, so that it met other draws.
  std::vector<int> only_here, only_there, other_draw;
};

/// Pairs rows of the same number, seed and labels. Labels that one side alone has are not compared.
/// The rows of a side have different numbers.
BaselinePairs PairWithBaseline(const RowColumns& columns, const std::vector<RunResult>& rows,
                               const RowColumns& baseline_columns,
                               const std::vector<RunResult>& baseline);

}  // namespace dockyard
