// Recognises the kind of an input file and checks the file, for `dockyard check`.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard {

/// Reads the file and every file that it names. The kind comes from the extension, for YAML from
/// the keys; the systems recognise files of their own. Throws ConfigError with the first fault,
/// also for a file of unknown kind.
FileCheck CheckFile(const std::string& file, const std::vector<System>& systems);

}  // namespace dockyard
