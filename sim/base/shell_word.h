// Words for a shell.
#pragma once

#include <string>
#include <string_view>

namespace dockyard {

/// The text as one word of a POSIX shell's command, in quotation marks only where it needs them.
std::string ShellWord(std::string_view text);

}  // namespace dockyard
