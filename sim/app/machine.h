// What this computer gives to the processes that run here: memory, disk, locks.
#pragma once

#include <filesystem>
#include <string>

namespace dockyard {

struct MemoryLimit {
  double mib = 0.0;
  std::string set_by;  // "free", "ulimit -v" or "cgroup"
};

/// The least of the memory that is free, of the limit on a process's address space, and of the
/// limits of this process's control groups (Linux's cgroup-v2.rst and cgroup-v1/memory.rst).
MemoryLimit UsableMemory();

/// The least limit named `file` from the group `group` ("/a/b") up to the root of `tree`; infinite
/// when none is set.
double CgroupLimitMib(const std::filesystem::path& tree, const std::string& group,
                      const std::string& file);

/// Raises the limits on this process's stack and data where they are too low and may be raised.
/// Returns a sentence on the one that is too small; empty if none is. Below them libraries crash,
/// such as the one that draws.
std::string LimitFault();

/// Free disk in a folder; 0 when it cannot be asked.
double FreeDiskMib(const std::filesystem::path& folder);

/// Why flock(2) does not keep a second opener out of a file in the folder; empty if it does.
std::string LockFault(const std::filesystem::path& folder);

}  // namespace dockyard
