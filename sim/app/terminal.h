// Messages for people, on stderr; stdout gets results only. Control characters in them are shown as
// escapes, so that no quoted word moves the terminal.
#pragma once

#include <string>
#include <vector>

namespace dockyard {

/// "error: ..." on stderr; the word in red on a terminal, unless NO_COLOR is set (no-color.org).
void PrintError(const std::string& message);
/// A line on stderr.
void PrintNote(const std::string& message);
/// "warning: ..." on stderr at once, and the text at the end of `warnings`: those of the call,
/// which a command's `--json` answer has under the key "warnings", as has the answer on a failure.
void Warn(const std::string& text, std::vector<std::string>* warnings);
/// Processors that this process may use, at least 1.
int UsableProcessors();

}  // namespace dockyard
