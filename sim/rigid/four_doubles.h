// Four numbers at a time: the same results as one at a time, in fewer instructions.
#pragma once

#include <cstring>

#include "controller/base/two_widths.h"

namespace dockyard {

typedef double FourDoubles __attribute__((vector_size(32)));

// At any address. By reference: how four numbers are passed by value depends on the processor.
inline void Load(const double* from, FourDoubles& four) { std::memcpy(&four, from, sizeof four); }
inline void Store(const FourDoubles& four, double* to) { std::memcpy(to, &four, sizeof four); }

}  // namespace dockyard

/// Of a function that works on fours, with all that it calls.
#define DOCKYARD_FOUR_AT_ONCE __attribute__((flatten)) DOCKYARD_TWO_WIDTHS
