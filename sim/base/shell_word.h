// Words for a shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dockyard {

/// The text as one word of a POSIX shell's command, in quotation marks only where it needs them.
std::string ShellWord(std::string_view text);

/// A command to be pasted: "build/dockyard replay 'my results' 3".
/// @param program  as it was called, as a word of a shell already
std::string CommandText(const std::string& program, const std::vector<std::string>& words);

}  // namespace dockyard
