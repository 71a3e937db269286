// Bytes changed at random, without libFuzzer.
#pragma once

#include <string>

#include "sim/base/random.h"

namespace dockyard {

/// One to four edits: bytes changed, removed or repeated, the end cut off, odd words put in.
std::string Mutated(std::string bytes, RandomStream& random);

}  // namespace dockyard
