#include "sim/axel/axel_columns.h"

namespace dockyard::axel {

std::vector<Column> Channels() {
  std::vector<Column> columns;
  VisitChannels(Truth{}, [&](const char* name, const char* unit, const char* meaning, double) {
    columns.push_back({name, unit, meaning});
  });
  return columns;
}

std::vector<Column> Measures() {
  std::vector<Column> columns;
  VisitMeasures({}, [&](const char* name, const char* unit, const std::string& meaning,
                        bool headline, double) {
    columns.push_back({name, unit, meaning, headline});
  });
  return columns;
}

std::vector<Column> Beliefs() {
  return {
      {"recoveries", "", "times that the controller backed up to try again"},
      {"rightings", "", "times that the controller turned body and arm back"},
      {"tether_length_m", "m", "exposed tether, arm tip to anchor, by the controller's estimate"}};
}

std::vector<double> Values(const AxelMeasures& measures) {
  std::vector<double> values;
  VisitMeasures(measures, [&](const char*, const char*, const std::string&, bool, double value) {
    values.push_back(value);
  });
  return values;
}

}  // namespace dockyard::axel
