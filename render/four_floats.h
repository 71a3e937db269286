// Four floats side by side, which the compiler keeps in one register of every x86-64 processor.
#pragma once

#include <cstdint>

namespace dockyard {

typedef float Four __attribute__((vector_size(16)));
/// What a comparison of Fours gives: all bits of a place, or none; also four whole numbers.
typedef std::int32_t FourInts __attribute__((vector_size(16)));

inline Four Mix(Four a, Four b, float t) { return a + t * (b - a); }

inline FourInts Truncated(Four a) { return __builtin_convertvector(a, FourInts); }
inline Four ToFloats(FourInts a) { return __builtin_convertvector(a, Four); }

}  // namespace dockyard
