// The margins of a campaign's runs: how often each limit was broken, and how near the others came.
#pragma once

#include <string>
#include <vector>

#include "sim/log/record.h"

namespace dockyard {

/// One limit over all runs in which it was judged.
struct LimitOverRuns {
  std::string name, unit, meaning;  // the name without "margin."
  int judged = 0, broken = 0;
  const RunResult* least = nullptr;  // the success with the least margin; null: there is none
  double least_margin = 0.0;         // its own
};

/// The limits that were judged at all: those broken most often first; of two broken as often, the
/// one whose least margin is a smaller share of its median margin. Points into the rows.
std::vector<LimitOverRuns> LimitsOverRuns(const RowColumns& columns,
                                          const std::vector<RunResult>& rows);

}  // namespace dockyard
