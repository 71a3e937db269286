#include "sim/base/math_pin.h"

#include <sys/auxv.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "sim/base/hash.h"

namespace dockyard {
namespace {

constexpr std::string_view kVariable = "GLIBC_TUNABLES";
constexpr std::string_view kName = "glibc.cpu.hwcaps=";

/// The list with the word in it: "a,b" and "c" give "a,b,c".
std::string WithWord(const std::string& list, const std::string& word) {
  const std::string framed = "," + list + ",";
  if (framed.find("," + word + ",") != std::string::npos) return list;
  return list.empty() ? word : list + "," + word;
}

/// Valgrind's tools are preloaded as vgpreload_*.so. Under them a program that starts itself again
/// leaves the tool, or is stopped by it.
[[maybe_unused]] bool UnderValgrind() {
  const char* preloaded = std::getenv("LD_PRELOAD");
  return preloaded != nullptr &&
         std::string_view(preloaded).find("/vgpreload_") != std::string_view::npos;
}

[[maybe_unused]] std::string TunablesNow() {
  const char* now = std::getenv(kVariable.data());
  return now == nullptr ? "" : now;
}

}  // namespace

std::string PinnedTunables(const std::string& tunables) {
  const std::string framed = ":" + tunables;
  const std::size_t at = framed.find(":" + std::string(kName));
  const bool given = at != std::string::npos;
  const std::size_t begin = given ? at + kName.size() : tunables.size();
  const std::size_t end = given ? std::min(tunables.find(':', begin), tunables.size()) : begin;
  // Switching off FMA selects the variants of plain SSE2, and of AVX, which round alike.
  std::string words = tunables.substr(begin, end - begin);
  for (const char* word : {"-FMA", "-FMA4"}) words = WithWord(words, word);
  if (given) return tunables.substr(0, begin) + words + tunables.substr(end);
  return (tunables.empty() ? "" : tunables + ":") + std::string(kName) + words;
}

bool MathIsPinned() {
#if defined(__x86_64__) && defined(__GLIBC__)
  return PinnedTunables(TunablesNow()) == TunablesNow();
#else
  return true;
#endif
}

bool PinMathFunctions(char** arguments) {
#if defined(__x86_64__) && defined(__GLIBC__)
  if (MathIsPinned()) return true;
  // A program with privileges of its own loses the variable at its start: it would never come back.
  if (::getauxval(AT_SECURE) != 0 || UnderValgrind()) return false;
  if (::setenv(kVariable.data(), PinnedTunables(TunablesNow()).c_str(), 1) != 0) return false;
  ::execv("/proc/self/exe", arguments);
  return false;  // it returned
#else
  (void)arguments;
  return true;
#endif
}

std::uint64_t MathFingerprint() {
  std::uint64_t hash = kHashSeed;
  for (int i = 1; i <= 200; ++i) {
    const double x = 0.0371 * i, unit = x / 7.5;
    for (const double value :
         {std::sin(x), std::cos(x), std::tan(x), std::asin(unit), std::acos(unit), std::atan(x),
          std::atan2(x, 1.7), std::exp(x), std::exp2(x), std::log(x), std::log10(x),
          std::pow(x, 1.37), std::sinh(x), std::cosh(x), std::tanh(x), std::cbrt(x), std::erfc(x),
          std::hypot(x, 0.3)}) {
      hash = HashDouble(hash, value);
    }
    const auto single = static_cast<float>(x);
    for (const float value : {std::sin(single), std::cos(single), std::exp(single),
                              std::log(single), std::pow(single, 1.37F)}) {
      hash = HashDouble(hash, static_cast<double>(value));
    }
  }
  return hash;
}

}  // namespace dockyard
