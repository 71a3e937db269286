// Which runs leave their log in the results folder.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "sim/log/record.h"
#include "sim/plan/campaign.h"

namespace dockyard {

/// Whether the run's log stays if it is a success.
bool StaysIfSuccess(const Keep& keep, int run);

/// Chooses by the runs' numbers and outcomes alone: whatever the order in which runs end, the same
/// logs are there in the end.
class Retention {
 public:
  explicit Retention(const Keep& keep) : keep_(keep) {}

  struct Choice {
    bool keep = false;
    std::optional<int> drop;  // the failure whose log gives way
  };
  Choice Choose(const RunResult& result);

 private:
  Keep keep_;
  std::map<std::string, std::set<int>> kept_failures_;  // by outcome
};

}  // namespace dockyard
