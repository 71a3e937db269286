#include "sim/app/doctor.h"

#include <cmath>

namespace dockyard {
namespace {

// Measured on Debian 12 (glibc 2.36, Mesa 22.3.6 with llvmpipe, GCC 12.2), on an AMD EPYC with AVX2
// and FMA, and with those masked.
constexpr const char* kMathematicsOfDebian12 = "09309fb7948a3b9b";

// Runs of Axel at 1024 x 768 had up to 254 MiB. With 683 MiB of address space they found no memory,
// with 977 MiB they ended.
constexpr double kRunMib = 300.0, kAddressSpaceMib = 1000.0;
// A run's log has 7 MB: room for a hundred.
constexpr double kDiskMib = 1024.0;

constexpr const char* kNoneBecause = "none: ";  // and the reason
constexpr const char* kNoImages =
    "No images: install libosmesa6, or libegl1 and set DOCKYARD_GL=egl.";
constexpr const char* kDiffers =
    "Runs here equal those of computers with this value, not those of Debian 12.";

std::string Mib(double mib) { return std::to_string(std::llround(mib)) + " MiB"; }

Finding Examined(const Fact& fact) {
  Finding finding{fact.name, fact.value, Health::kOk, ""};
  const auto warn = [&](const std::string& advice) {
    finding.health = Health::kWarning;
    finding.advice = advice;
  };
  if (fact.name == "variants" && fact.value != "pinned") {
    warn("Runs here may differ from those of other processors: start it without set-user-ID.");
  } else if (fact.name == "mathematics" && fact.value != kMathematicsOfDebian12) {
    warn(kDiffers);
  } else if (fact.name == "gl_renderer" && fact.value.starts_with(kNoneBecause)) {
    finding.health = Health::kMissing;
    finding.advice = kNoImages;
  } else if (fact.value == "unknown") {
    warn("It is not told here; write it down yourself.");
  }
  return finding;
}

Finding ExamineMemory(const MemoryLimit& memory, int processors) {
  Finding finding{"memory", Mib(memory.mib) + " (" + memory.set_by + ")", Health::kOk, ""};
  const bool of_each = memory.set_by == "ulimit -v";  // address space, of every process
  const double needed_mib = of_each ? kAddressSpaceMib : kRunMib;
  if (memory.mib < needed_mib) {
    finding.health = Health::kMissing;
    finding.advice = "A run needs " + Mib(needed_mib) + ".";
  } else if (!of_each && memory.mib < kRunMib * processors) {
    finding.health = Health::kWarning;
    finding.advice = "A run needs " + Mib(kRunMib) + ": use --jobs " +
                     std::to_string(static_cast<int>(memory.mib / kRunMib)) + ".";
  }
  return finding;
}

}  // namespace

std::string Name(Health health) {
  switch (health) {
    case Health::kOk:
      return "ok";
    case Health::kWarning:
      return "warning";
    case Health::kMissing:
      return "missing";
  }
  return "";
}

std::vector<Finding> ExamineFacts(const std::vector<Fact>& facts) {
  std::vector<Finding> findings;
  for (const Fact& fact : facts) findings.push_back(Examined(fact));
  return findings;
}

Finding ExamineImages(const std::string& system, const std::string& value,
                      const std::string& of_debian12) {
  Finding finding{kImages + system, value, Health::kOk, ""};
  if (value.starts_with(kNoneBecause)) {
    finding.health = Health::kMissing;
    finding.advice = kNoImages;
  } else if (value == kNoScenario) {
    finding.health = Health::kWarning;
    finding.advice = "Its scenario is not found: start the program that is installed, or call it " +
                     std::string("in Dockyard's folder.");
  } else if (!of_debian12.empty() && value != of_debian12) {
    finding.health = Health::kWarning;
    finding.advice = kDiffers;
  }
  return finding;
}

std::vector<Finding> ExamineMachine(int processors, const MemoryLimit& memory, double disk_mib,
                                    const std::string& lock_fault, double shared_mib) {
  std::vector<Finding> findings{{"processors", std::to_string(processors), Health::kOk, ""},
                                ExamineMemory(memory, processors)};
  Finding disk{"disk", Mib(disk_mib) + " free in this folder", Health::kOk, ""};
  if (disk_mib < kDiskMib) {
    disk.health = Health::kWarning;
    disk.advice = "A kept log takes 7 MB a run: use another folder, or keep: none.";
  }
  Finding lock{"lock", "works in this folder", Health::kOk, ""};
  if (!lock_fault.empty()) {
    lock.value = lock_fault;
    lock.health = Health::kWarning;
    lock.advice = "Results cannot be guarded here: start one campaign a folder, or use another.";
  }
  Finding shared{"/dev/shm", Mib(shared_mib) + " free", Health::kOk, ""};
  if (shared_mib <= 0.0) {
    shared.health = Health::kWarning;
    shared.advice = "Dockyard needs none, but a controller's program may: mount a tmpfs there.";
  }
  findings.insert(findings.end(), {disk, lock, shared});
  return findings;
}

}  // namespace dockyard
