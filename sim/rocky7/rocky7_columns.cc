#include "sim/rocky7/rocky7_columns.h"

namespace dockyard::rocky7 {

std::vector<Column> Channels() {
  std::vector<Column> columns;
  VisitChannels(Truth{}, [&](const char* name, const char* unit, const char* meaning, double) {
    columns.push_back({name, unit, meaning});
  });
  return columns;
}

std::vector<Column> Measures() {
  std::vector<Column> columns;
  VisitMeasures(
      {}, [&](const char* name, const char* unit, const char* meaning, bool headline, double) {
        columns.push_back({name, unit, meaning, headline});
      });
  return columns;
}

std::vector<Column> Beliefs() {
  return {{"target_x_m", "m", "the target in the rover's plan, as believed"},
          {"target_y_m", "m", "the same, to the left"},
          {"looks", "", "pairs of pictures so far"},
          {"grasps", "", "times that the arm was sent out so far"}};
}

std::vector<double> Values(const Rocky7Measures& measures) {
  std::vector<double> values;
  VisitMeasures(measures, [&](const char*, const char*, const char*, bool, double value) {
    values.push_back(value);
  });
  return values;
}

}  // namespace dockyard::rocky7
