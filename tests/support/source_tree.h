// Where the source tree lies. One file alone gets the path from the build, so that all other
// objects are the same in every clone and ccache finds them again.
#pragma once

#include <string>

namespace dockyard {

std::string SourceDir();
/// The path of a file or folder of the tree, named from its top.
std::string SourceFile(const std::string& name);

}  // namespace dockyard
