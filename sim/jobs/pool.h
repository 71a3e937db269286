// Many jobs on a few workers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "sim/jobs/signal_queue.h"
#include "sim/jobs/worker.h"

namespace dockyard {

struct Job {
  std::int64_t number = 0;         // by which caller and worker know it
  std::filesystem::path messages;  // file for what it prints
};

struct PoolOptions {
  int workers = 1;  // at once, >= 1
  JobLimits limits;
  int retries = 1;                             // of a job that was lost, >= 0
  std::vector<int> close_in_worker{};          // descriptors that are the caller's alone
  std::function<void(int running)> waiting{};  // called at least five times a second; may be empty
};

/// What the pool asks of its caller.
struct PoolCalls {
  JobWork work;  // in the worker
  /// The next job for the worker at this place (0 .. workers - 1); none when there is none now. It
  /// is asked again when another job has ended.
  std::function<std::optional<Job>(int place)> next;
  /// Before each attempt at a job; may be empty.
  std::function<void(const Job&, int place)> prepare;
  /// Takes a job's end, in the order in which the jobs end.
  std::function<void(const Job&, int place, const JobEnd&)> take;
};

/// Runs jobs until `next` gives none and none runs. A worker goes on from job to job; a job that is
/// lost is tried again in a new worker. Returns 0, or the signal that stopped it: it then kills the
/// jobs under way and does not call `take` for them. An exception of the caller's functions is
/// passed on after all workers are gone; no worker outlives the call. Throws IoError when no
/// process can be had.
int RunPool(const PoolOptions& options, SignalQueue& signals, const PoolCalls& calls);

}  // namespace dockyard
