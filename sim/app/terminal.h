// Messages for people, on stderr; stdout gets results only.
#pragma once

#include <string>
#include <vector>

namespace dockyard {

/// "error: ..." on stderr; the word in red on a terminal, unless NO_COLOR is set (no-color.org).
void PrintError(const std::string& message);
/// A line on stderr.
void PrintNote(const std::string& message);
/// "warning: ..." on stderr at once, and the text at the end of `warnings`: a command's `--json`
/// answer has them all under the key "warnings".
void Warn(const std::string& text, std::vector<std::string>* warnings);
/// All of them so far, for an answer that no command gives: that on a failure.
const std::vector<std::string>& WarningsSaid();
/// Processors that this process may use, at least 1.
int UsableProcessors();

}  // namespace dockyard
