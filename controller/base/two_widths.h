// Loops over arrays for 16 and for 32 bytes at once; the processor decides at start. Both
// do the same operations on each element (no fused multiply-add), so the bits are the same.
// By GCC alone: Clang wants the attribute at the declaration in the header. DOCKYARD_ONE_WIDTH
// leaves four alone, for checks that take the attribute for a difference in type.
#pragma once

#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(DOCKYARD_ONE_WIDTH)
#define DOCKYARD_TWO_WIDTHS __attribute__((target_clones("avx2", "default")))
#else
#define DOCKYARD_TWO_WIDTHS
#endif
