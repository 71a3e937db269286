#include "sim/axel/axel_columns.h"

#include "sim/log/visited_columns.h"

namespace dockyard::axel {

std::vector<Column> Channels() {
  return ColumnsVisited([](const auto& visit) { VisitChannels(Truth{}, visit); });
}

std::vector<Column> Measures() {
  return WithMargins(MeasuresVisited([](const auto& visit) { VisitMeasures({}, visit); }),
                     OutcomeJudge({}, {}).Limits({}));
}

std::vector<Column> Beliefs() {
  return {
      {"recoveries", "", "times that the controller backed up to try again"},
      {"rightings", "", "times that the controller turned body and arm back"},
      {"tether_length_m", "m", "exposed tether, arm tip to anchor, by the controller's estimate"}};
}

std::vector<double> Values(const AxelMeasures& measures) {
  return ValuesVisited([&](const auto& visit) { VisitMeasures(measures, visit); });
}

}  // namespace dockyard::axel
