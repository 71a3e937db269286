// What results depend on beside the files: this program, this computer's processor, its libraries.
#pragma once

#include <string>
#include <vector>

namespace dockyard {

struct Fact {
  std::string name, value;

  bool operator==(const Fact&) const = default;
};

/// In a fixed order, one line of text each, no comma:
///   dockyard     the version
///   program      a fingerprint of the file that runs
///   processor    its name
///   vectors      the widest vector instructions: AVX-512, AVX2 and FMA, AVX, SSE4.2 or SSE2
///   libc         the C library and its version
///   variants     of its functions: "pinned" (math_pin.h), or "of the processor"
///   mathematics  MathFingerprint() in hexadecimal: equal on computers whose runs are equal
///   opencv, bullet, compiler   versions
/// What cannot be found out is "unknown". Takes some milliseconds: the program's file is read.
std::vector<Fact> Environment();

}  // namespace dockyard
