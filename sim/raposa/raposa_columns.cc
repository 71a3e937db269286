#include "sim/raposa/raposa_columns.h"

namespace dockyard::raposa {

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
  return {{"state", "", "number of the state; of ferreira2009 as its authors count them"},
          {"alpha_deg", "deg", "the camera's place about the pyramid's axis, as believed"},
          {"r_m", "m", "camera to guide, as believed"},
          {"passes", "", "times that it manoeuvred to the pyramid's axis"},
          {"gauge_share", "", "turns by the told gauge that come about, as believed"}};
}

std::vector<double> Values(const RaposaMeasures& measures) {
  std::vector<double> values;
  VisitMeasures(measures, [&](const char*, const char*, const char*, bool, double value) {
    values.push_back(value);
  });
  return values;
}

}  // namespace dockyard::raposa
