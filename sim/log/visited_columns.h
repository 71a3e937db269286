// Columns and their values of a visitor: a function that calls its argument for each number of a
// system with name, unit, meaning and value, so that each number stands in one place.
#pragma once

#include <string>
#include <vector>

#include "sim/log/column.h"

namespace dockyard {

/// Of visit_all(f), which calls f(name, unit, meaning, value).
template <class VisitAll>
std::vector<Column> ColumnsVisited(VisitAll&& visit_all) {
  std::vector<Column> columns;
  visit_all([&](const char* name, const char* unit, const std::string& meaning, double) {
    columns.push_back({name, unit, meaning});
  });
  return columns;
}

/// Of visit_all(f), which calls f(name, unit, meaning, headline, value).
template <class VisitAll>
std::vector<Column> MeasuresVisited(VisitAll&& visit_all) {
  std::vector<Column> columns;
  visit_all(
      [&](const char* name, const char* unit, const std::string& meaning, bool headline, double) {
        columns.push_back({name, unit, meaning, headline});
      });
  return columns;
}
template <class VisitAll>
std::vector<double> ValuesVisited(VisitAll&& visit_all) {
  std::vector<double> values;
  visit_all([&](const char*, const char*, const std::string&, bool, double value) {
    values.push_back(value);
  });
  return values;
}

/// Of a system whose truth and measures have VisitChannels and VisitMeasures.
template <class Truth>
std::vector<Column> ChannelsOf() {
  return ColumnsVisited([](const auto& visit) { VisitChannels(Truth{}, visit); });
}
template <class Measures>
std::vector<Column> MeasuresOf() {
  return MeasuresVisited([](const auto& visit) { VisitMeasures(Measures{}, visit); });
}
template <class Measures>
std::vector<double> Values(const Measures& measures) {
  return ValuesVisited([&](const auto& visit) { VisitMeasures(measures, visit); });
}

}  // namespace dockyard
