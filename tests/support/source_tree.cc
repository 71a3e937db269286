#include "support/source_tree.h"

namespace dockyard {

std::string SourceDir() { return DOCKYARD_SOURCE_DIR; }

std::string SourceFile(const std::string& name) { return SourceDir() + "/" + name; }

}  // namespace dockyard
