// The same sine and logarithm on every processor. The C library has variants of its functions, and
// picks those with fused multiply-add where the processor has it: they round otherwise.
#pragma once

#include <cstdint>
#include <string>

namespace dockyard {

/// `tunables` (a value of GLIBC_TUNABLES) with the variants with fused multiply-add switched off.
std::string PinnedTunables(const std::string& tunables);

/// Starts the program again, in the same process and with the same arguments, under PinnedTunables;
/// returns if it runs under them already. The C library reads them at its start alone. Elsewhere
/// than on x86-64 with the GNU C library it does nothing. Returns false if the program cannot be
/// started again, or runs under Valgrind, whose tool it would leave; it then runs on with the
/// variants of its processor.
bool PinMathFunctions(char** arguments);

/// Whether the program was started under PinnedTunables, or needs not be.
bool MathIsPinned();

/// A fingerprint of the values that the C library's functions give here: equal on computers whose
/// runs are equal bit for bit.
std::uint64_t MathFingerprint();

}  // namespace dockyard
