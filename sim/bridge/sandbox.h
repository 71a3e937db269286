// A program that can reach nothing but its own folder: under bubblewrap, in name spaces of its own.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/bridge/process.h"

namespace dockyard {

/// A sandbox that cannot be had. The message is a sentence: what to install, allow or move.
class SandboxError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Limits in the sandbox. The first group holds for each process, the second for all together.
// Assumed: a controller with OpenCV or PyTorch on one computer's processor fits well inside.
inline constexpr std::int64_t kSandboxAddressMib = 4096;  // RLIMIT_AS; assumed, 1024-16384
inline constexpr std::int64_t kSandboxCpu_s = 3600;       // RLIMIT_CPU; assumed, 60-86400
inline constexpr std::int64_t kSandboxFileMib = 64;       // RLIMIT_FSIZE; assumed, 1-1024
inline constexpr std::int64_t kSandboxOpenFiles = 64;     // RLIMIT_NOFILE; assumed, 32-1024

inline constexpr std::int64_t kSandboxThreads = 128;     // and RLIMIT_NPROC; assumed, 32-512
inline constexpr std::int64_t kSandboxMemoryMib = 2048;  // in main memory; assumed, 512-8192
inline constexpr std::int64_t kSandboxScratchMib = 64;   // /tmp and /dev/shm; assumed, 16-1024

/// The program's start under bubblewrap. It sees the system's programs and libraries, and its
/// folder, all read-only; an own /proc, /tmp and /dev; no network, and no other process.
/// @param hidden  a results folder: empty where it lies in what the program sees
/// Throws SandboxError for a folder that holds more than a program: the root, the user's own, the
/// results folder.
ProgramStart InSandbox(const std::vector<std::string>& words, const std::filesystem::path& folder,
                       const std::filesystem::path& hidden);

/// Starts a trial program in such a sandbox, once in a process. Throws SandboxError where there is
/// no bubblewrap, or where it cannot make its name spaces.
void RequireSandbox();

}  // namespace dockyard
