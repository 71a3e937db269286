// The limits of a judgement by name: what was found, what was asked for, and how far apart they
// are.
#pragma once

#include <string>
#include <vector>

#include "sim/base/json.h"
#include "sim/log/column.h"

namespace dockyard {

enum class LimitSense { kAtLeast, kAtMost };

struct JudgedLimit {
  std::string name;     // ends in its unit: "seat_depth_m"
  std::string unit;     // "m", "deg", "N", "s"
  std::string meaning;  // of the value
  LimitSense sense = LimitSense::kAtLeast;
  double value = 0.0;  // NaN: the limit was not judged in this run
  double limit = 0.0;

  /// In the unit; positive is good. NaN: not judged.
  double margin() const { return sense == LimitSense::kAtLeast ? value - limit : limit - value; }
};

/// Whether the measure is a limit's margin: "margin.seat_depth_m".
bool IsMargin(const Column& measure);
/// Adds a measure for the margin of each limit, in their order.
std::vector<Column> WithMargins(std::vector<Column> measures,
                                const std::vector<JudgedLimit>& limits);

/// "seat depth 189 mm (at least 225 mm)"
std::string LimitText(const JudgedLimit& limit);
/// The same of all limits that are not kept, with commas between; empty if all are.
std::string BrokenLimitsText(const std::vector<JudgedLimit>& limits);
/// The limit with the least margin as a share of the limit itself; null if none was judged.
const JudgedLimit* TightestLimit(const std::vector<JudgedLimit>& limits);

/// Of the judged ones: [{name, unit, value, limit, sense, margin}].
Json LimitsJson(const std::vector<JudgedLimit>& limits);

}  // namespace dockyard
