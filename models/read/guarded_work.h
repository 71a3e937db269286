// Work on input that may be hostile, in a process of its own with limits: a crash, a loop or a bomb
// there ends that process alone.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace dockyard {

struct WorkLimits {
  int cpu_s = 0;        // processor time, whole seconds
  double wall_s = 0.0;  // in case it waits instead
  // Address space beyond what the caller has. Under AddressSanitizer, which reserves terabytes,
  // there is no limit.
  std::size_t memory_bytes = 0;
  std::size_t answer_bytes = 0;
};

struct WorkResult {
  std::string answer;   // whole if `failure` is empty
  std::string failure;  // "crashed: killed by signal 11 (Segmentation fault)", "took more than 9 s"
};

/// Runs the work in a forked child that answers over a pipe. The child writes no file, prints
/// nothing, leaves no core file and dies with its parent; signals from the keyboard are its
/// parent's to handle. An exception from the work counts as a crash. Throws std::system_error when
/// no process can be had.
WorkResult RunGuarded(const WorkLimits& limits, const std::function<std::string()>& work);

}  // namespace dockyard
