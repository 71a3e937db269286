// Many pieces of work on a few processes.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/jobs/child.h"
#include "sim/jobs/signal_queue.h"

namespace dockyard {

struct Job {
  std::size_t index = 0;              // by which the caller knows it
  std::function<std::string()> work;  // runs in the child; must not throw
  std::filesystem::path messages;     // file for what the child prints
};

struct PoolOptions {
  int processes = 1;                  // at once, >= 1
  double time_limit_s = 0.0;          // wall time of one job, > 0; a job beyond it is killed
  std::vector<int> close_in_child{};  // descriptors that are the caller's alone
  std::function<void(int running)> waiting{};  // called at least once a second; may be empty
};

/// Starts the jobs that `next` gives while processes are free, until it gives none. Hands the end
/// of each job to `take`, in the order in which the jobs end. Returns 0, or the signal that stopped
/// it: it then kills the jobs under way and does not call `take` for them. An exception of `next`
/// or `take` is passed on after all children are gone; no child outlives the call. Throws IoError
/// when no process can be started.
int RunPool(const PoolOptions& options, SignalQueue& signals,
            const std::function<std::optional<Job>()>& next,
            const std::function<void(std::size_t index, const Child::End& end)>& take);

}  // namespace dockyard
