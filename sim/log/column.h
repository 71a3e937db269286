// The meaning of a system's numbers: each is stated once, by name and unit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dockyard {

struct Column {
  std::string name;       // ends in its unit where it has one: "tip_depth_m"
  std::string unit;       // "m", "deg", "A"; empty for a count or a share
  std::string meaning;    // where, when and against what it is measured
  bool headline = false;  // shown in a campaign's summary table
};

/// How a run can end.
struct OutcomeName {
  std::string name;  // "docked", "no_detection"
  bool success = false;
  std::string meaning;
};

/// Outcomes that every system has beside its own. The engine gives them, no judge does.
inline constexpr const char* kCrashed = "crashed";  // the run's process died by its own fault
inline constexpr const char* kStopped = "stopped";  // it was ended by a limit or from outside
/// Whether the run has no result.
inline bool IsLost(std::string_view outcome) { return outcome == kCrashed || outcome == kStopped; }

/// The meaning of a result row's vectors, in their order.
struct RowColumns {
  std::vector<std::string> labels;    // columns of the campaign's table, the run's number left out
  std::vector<Column> measures;       // of the system
  std::vector<OutcomeName> outcomes;  // of the system, then those of every system
  // Of results that an earlier program wrote: `docked` alone tells a success, and no margins.
  bool former = false;

  bool IsSuccess(const std::string& outcome) const {
    for (const OutcomeName& known : outcomes) {
      if (known.name == outcome) return known.success;
    }
    return false;
  }
};

}  // namespace dockyard
