#include "support/program_path.h"

namespace dockyard {

std::string ProgramPath() { return DOCKYARD_PROGRAM; }

}  // namespace dockyard
