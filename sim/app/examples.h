// The examples in the program's help, and their files.
#pragma once

#include <filesystem>
#include <string>

#include "sim/run/system.h"

namespace dockyard {

/// The help with `dockyard` at the head of a line called as the program was, and with the system's
/// files in place of {scenario}, {campaign}, {campaign_name}, {sweep}, {robot}, {target} and
/// {cameras}. A line whose file is empty is left out.
std::string WithExamples(const std::string& help, const std::string& program,
                         const ExampleFiles& files);

/// A file of ExampleFiles: of the installed program, else in the tree that the program's build
/// folder lies in, else in the working folder. Empty: in none of them.
std::filesystem::path FindExample(const std::string& file);

}  // namespace dockyard
