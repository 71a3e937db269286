// The exit codes of the program; docs/reference/exit_codes.md explains them.
#pragma once

namespace dockyard {

inline constexpr int kExitDone = 0;      // done; run: a success; replay: the same
inline constexpr int kExitOurBug = 1;    // a fault of this program; replay: not the same
inline constexpr int kExitUsage = 2;     // arguments that make no sense
inline constexpr int kExitBadInput = 3;  // a file that is wrong
inline constexpr int kExitNoSuccess =
    4;  // run: simulated to its end, but did not succeed; plan: none
// campaign: runs missing or crashed; run: stopped; replay: no such result; wheel: not steady;
// doctor: no runs here
inline constexpr int kExitIncomplete = 10;
inline constexpr int kExitNotAccepted = 20;  // accept: the reliability is lower
inline constexpr int kExitUndecided = 21;    // accept: too few runs to tell
inline constexpr int kExitNotMet = 22;       // campaign, merge: a requirement is not met
inline constexpr int kExitWorse = 23;        // compare: worse, as --fail-if-worse asks
inline constexpr int kExitOutside = 30;      // reproduce: the paper's counts are not predicted
inline constexpr int kExitIo = 50;           // a folder or file that cannot be written or read
inline constexpr int kExitSignal = 128;      // plus the signal's number: 130 Ctrl-C, 143 terminated

}  // namespace dockyard
