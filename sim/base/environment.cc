#include "sim/base/environment.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <opencv2/core/version.hpp>

#include "sim/base/files.h"
#include "sim/base/hash.h"
#include "sim/base/math_pin.h"

namespace dockyard {
namespace {

constexpr const char* kUnknown = "unknown";

std::string ProgramFingerprint() {
  try {
    const auto bytes = ReadWhole("/proc/self/exe");
    if (bytes) return HexText(HashText(kHashSeed, *bytes));
  } catch (const IoError&) {
    return kUnknown;
  }
  return kUnknown;
}

/// As Linux names it: "model name : Intel(R) Xeon(R) ...".
std::string ProcessorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    const std::size_t begin = line.find_first_not_of(": \t", line.find(':'));
    if (begin == std::string::npos) break;
    std::string name = line.substr(begin);
    std::replace(name.begin(), name.end(), ',', ' ');
    return name;
  }
  return kUnknown;
}

std::string Vectors() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return "AVX-512";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "AVX2 and FMA";
  if (__builtin_cpu_supports("avx")) return "AVX";
  if (__builtin_cpu_supports("sse4.2")) return "SSE4.2";
  return "SSE2";
#else
  return kUnknown;
#endif
}

std::string LibcVersion() {
#ifdef _CS_GNU_LIBC_VERSION
  char text[64] = "";
  if (::confstr(_CS_GNU_LIBC_VERSION, text, sizeof text) > 0) return text;
#endif
  return kUnknown;
}

}  // namespace

std::vector<Fact> Environment() {
  return {{"dockyard", DOCKYARD_VERSION},
          {"program", ProgramFingerprint()},
          {"processor", ProcessorName()},
          {"vectors", Vectors()},
          {"libc", LibcVersion()},
          {"variants", MathIsPinned() ? "pinned" : "of the processor"},
          {"mathematics", HexText(MathFingerprint())},
          {"opencv", CV_VERSION},
          {"bullet", DOCKYARD_BULLET_VERSION},
          {"compiler", DOCKYARD_COMPILER}};
}

}  // namespace dockyard
