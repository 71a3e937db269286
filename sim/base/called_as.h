// Commands in messages: they run when they are pasted into the shell that called this program.
#pragma once

#include <string>
#include <vector>

namespace dockyard {

/// Takes argv[0]. Once, at the program's start; without it the program is called "dockyard".
void SetCalledAs(const std::string& argv_0);
/// The program as it was called, as a word of a shell: "build/dockyard".
std::string CalledAs();
/// "build/dockyard replay 'my results' 3": each word as the shell needs it.
std::string CommandText(const std::vector<std::string>& words);

}  // namespace dockyard
