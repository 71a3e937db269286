// Messages for people, on stderr; stdout gets results only.
#pragma once

#include <string>

namespace dockyard {

/// "error: ..." on stderr; the word in red on a terminal, unless NO_COLOR is set (no-color.org).
void PrintError(const std::string& message);
/// A line on stderr.
void PrintNote(const std::string& message);
/// Processors that this process may use, at least 1.
int UsableProcessors();

}  // namespace dockyard
