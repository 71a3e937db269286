// What a computer has for runs, and what to do where it lacks something.
#pragma once

#include <string>
#include <vector>

#include "sim/app/machine.h"
#include "sim/base/environment.h"

namespace dockyard {

enum class Health { kOk, kWarning, kMissing };  // missing: runs are not possible

struct Finding {
  std::string name, value;
  Health health = Health::kOk;
  std::string advice;  // a sentence; empty if all is well
};

/// Of Environment() and RendererFacts(): whether runs here equal those of other computers.
std::vector<Finding> ExamineFacts(const std::vector<Fact>& facts);

/// The name of the finding on a system's images is this and the system's.
inline constexpr const char* kImages = "image_";
/// In place of a fingerprint.
inline constexpr const char* kNoScenario = "unknown";
/// @param value        StartImages(), or kNoScenario
/// @param of_debian12  the value there; empty: not known
Finding ExamineImages(const std::string& system, const std::string& value,
                      const std::string& of_debian12);

/// @param lock_fault  of the folder for results, as LockFault says
std::vector<Finding> ExamineMachine(int processors, const MemoryLimit& memory, double disk_mib,
                                    const std::string& lock_fault, double shared_mib);

/// "ok", "warning" or "missing".
std::string Name(Health health);

}  // namespace dockyard
