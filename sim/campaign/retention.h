// Which runs leave their log in the results folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "sim/log/record.h"
#include "sim/plan/campaign.h"

namespace dockyard {

/// Chooses by the runs' numbers and outcomes alone: whatever the order in which runs end, the same
/// logs are there in the end.
class Retention {
 public:
  explicit Retention(const Keep& keep) : keep_(keep) {}

  /// A run of an earlier program whose log is there.
  void AddKept(const RunResult& result);

  struct Choice {
    bool keep = false;
    std::optional<int> drop;  // the run whose log gives way
  };
  Choice Choose(const RunResult& result);

 private:
  Keep keep_;
  std::map<std::string, std::set<int>> kept_failures_;  // by outcome
};

}  // namespace dockyard
