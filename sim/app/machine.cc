#include "sim/app/machine.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>

namespace dockyard {
namespace {

namespace fs = std::filesystem;

constexpr double kMib = 1024.0 * 1024.0;
constexpr double kNone = std::numeric_limits<double>::infinity();

/// "MemAvailable:  1234 kB" of /proc/meminfo.
double AvailableMib() {
  std::ifstream file("/proc/meminfo");
  for (std::string name; file >> name;) {
    double kib = 0.0;
    file >> kib;
    if (name == "MemAvailable:") return kib / 1024.0;
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return kNone;
}

/// This process's groups: lines "0::/a/b" (version 2) and "4:memory:/a" (version 1).
double OwnCgroupLimitMib() {
  double least = kNone;
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string kind = line.substr(first + 1, second - first - 1);
    const std::string group = line.substr(second + 1);
    if (kind.empty()) {
      least = std::min(least, CgroupLimitMib("/sys/fs/cgroup", group, "memory.max"));
    } else if (("," + kind + ",").find(",memory,") != std::string::npos) {
      const char* limit = "memory.limit_in_bytes";
      least = std::min(least, CgroupLimitMib("/sys/fs/cgroup/memory", group, limit));
    }
  }
  return least;
}

struct Opened {
  explicit Opened(const char* file) : descriptor(::open(file, O_RDWR | O_CLOEXEC)) {}
  ~Opened() {
    if (descriptor >= 0) ::close(descriptor);
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  int descriptor;
};

std::string FaultBetween(const char* file) {
  const Opened one(file), two(file);
  if (one.descriptor < 0 || two.descriptor < 0) return std::strerror(errno);
  if (::flock(one.descriptor, LOCK_EX | LOCK_NB) != 0) return std::strerror(errno);
  if (::flock(two.descriptor, LOCK_EX | LOCK_NB) == 0) return "two holders of one lock";
  return errno == EWOULDBLOCK ? "" : std::strerror(errno);
}

/// Raises a limit of this process to `least` bytes or says why not.
std::string FaultOf(decltype(RLIMIT_STACK) kind, rlim_t least, const std::string& name,
                    const std::string& command) {
  rlimit limit{};
  if (::getrlimit(kind, &limit) != 0 || limit.rlim_cur >= least) return "";
  const rlim_t found = limit.rlim_cur;
  limit.rlim_cur = least;
  if (limit.rlim_max >= least && ::setrlimit(kind, &limit) == 0) return "";
  return "the program's " + name + " may take " + std::to_string(found >> 10) + " KiB alone (" +
         command + "); give it " + std::to_string(least >> 20) + " MiB or more";
}

}  // namespace

double CgroupLimitMib(const fs::path& tree, const std::string& group, const std::string& file) {
  double least = kNone;
  for (fs::path at = fs::path(group).relative_path();; at = at.parent_path()) {
    double bytes = 0.0;
    // A group without a limit says "max", or a number beyond all memory.
    if (std::ifstream(tree / at / file) >> bytes) least = std::min(least, bytes / kMib);
    if (at.empty()) return least;
  }
}

MemoryLimit UsableMemory() {
  MemoryLimit least{AvailableMib(), "free"};
  const double group_mib = OwnCgroupLimitMib();
  if (group_mib < least.mib) least = {group_mib, "cgroup"};
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    const double own_mib = static_cast<double>(limit.rlim_cur) / kMib;
    if (own_mib < least.mib) least = {own_mib, "ulimit -v"};
  }
  return least;
}

std::string LimitFault() {
  // Assumed, 0.5 to 8 MiB: the deepest reader takes about 0.3 MiB.
  std::string fault = FaultOf(RLIMIT_STACK, 1u << 20, "stack", "ulimit -s");
  // Assumed, 16 to 128 MiB: a short run was measured to need 12 MiB, and to crash with 8.
  if (fault.empty()) fault = FaultOf(RLIMIT_DATA, 32u << 20, "data", "ulimit -d");
  return fault;
}

double FreeDiskMib(const fs::path& folder) {
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  return error ? 0.0 : static_cast<double>(space.available) / kMib;
}

std::string LockFault(const fs::path& folder) {
  std::string file = (folder / "dockyard-doctor-XXXXXX").string();
  const int made = ::mkstemp(file.data());
  if (made < 0) return std::strerror(errno);
  ::close(made);
  const std::string fault = FaultBetween(file.c_str());
  ::unlink(file.c_str());
  return fault;
}

}  // namespace dockyard
