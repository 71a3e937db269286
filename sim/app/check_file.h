// What kind of input file is this, and is it good? For `dockyard check`.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard {

/// Reads the file and everything that it names. The kind comes from the extension, for YAML from
/// the keys; systems say which files are theirs. Throws ConfigError with the first fault, also when
/// it is of no kind that is known.
FileCheck CheckFile(const std::string& file, const std::vector<System>& systems);

}  // namespace dockyard
