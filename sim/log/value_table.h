// Values of a controller's belief that its system does not name: a table next to the history.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/log/record.h"

namespace dockyard {

inline constexpr const char* kValuesFile = "values.csv";
/// Names of values in one run, at most. Assumed, 256-4096: a program may name one for each thing
/// that it finds.
inline constexpr std::size_t kMostValueNames = 1024;

/// The belief's values that none of the columns has, in the order of the names; NaN for one that it
/// lacks. A name that is new goes to their end.
std::vector<double> FurtherValues(const Belief& belief, const std::vector<Column>& columns,
                                  std::vector<std::string>& names);

/// One line per sample of the history, header first: its time, and each value by its name; `nan`
/// where there is none. A value called `time_s` is called `value.time_s` there.
std::string ValuesCsv(const RunRecord& record);

}  // namespace dockyard
