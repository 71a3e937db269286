// The processes that this one started, with all that these started in turn.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <cstdint>
#include <vector>

namespace dockyard {

/// Of user and system.
double ProcessorSeconds(const rusage& usage);

/// While it lives, a process below this one whose parent ends becomes our child: none is lost by
/// starting itself anew, as daemons do.
class Descendants {
 public:
  /// Those that run already are none of its.
  Descendants();
  /// Leaves this process as it was.
  ~Descendants();
  Descendants(const Descendants&) = delete;
  Descendants& operator=(const Descendants&) = delete;

  struct Use {
    std::int64_t threads = 0, memory_bytes = 0;
  };
  /// What they have now, all together; memory is what is in the computer's main memory.
  Use Count() const;

  /// Kills all of them but these children and theirs, and waits for their end, up to 10 s. Returns
  /// the processor time in seconds that they had.
  double End(const std::vector<pid_t>& keep = {});

 private:
  std::vector<pid_t> before_;
  bool adopted_before_ = false;
};

}  // namespace dockyard
