// Calls of the system that a program in a sandbox may not make.
#pragma once

#include <string>

namespace dockyard {

/// A filter in the form that seccomp(2) takes. It refuses memory that no limit counts
/// (memfd_create, System V's shared memory), and doors into the kernel that no controller needs:
/// keys, BPF, io_uring, performance counters, user faults, tracing. Empty where the processor is
/// not known to us.
std::string CallFilter();

}  // namespace dockyard
