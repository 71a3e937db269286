// The program that a test runs, as PROGRAM of room_test names it. One file alone gets its path, as
// in source_tree.h.
#pragma once

#include <string>

namespace dockyard {

std::string ProgramPath();

}  // namespace dockyard
