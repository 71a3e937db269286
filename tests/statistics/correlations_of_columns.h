// Rank correlations of columns that are there at once, by the table that takes them one by one.
#pragma once

#include <vector>

#include "sim/statistics/ranks.h"

namespace dockyard {

/// Of the inputs with one output.
inline RankCorrelations CorrelationsOf(const std::vector<std::vector<double>>& inputs,
                                       const std::vector<double>& output) {
  RankTable table(output.size(), inputs.size() + 1);
  for (const std::vector<double>& input : inputs) table.AddInput(Ranks(input));
  table.AddOutput(Ranks(output));
  return table.Correlate();
}
inline Estimate Spearman(const std::vector<double>& x, const std::vector<double>& y) {
  return CorrelationsOf({x}, y).spearman[0][0];
}
inline std::vector<Estimate> PartialRankCorrelations(const std::vector<std::vector<double>>& inputs,
                                                     const std::vector<double>& output) {
  return CorrelationsOf(inputs, output).partial[0];
}

}  // namespace dockyard
