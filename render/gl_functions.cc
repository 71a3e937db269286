#include "render/gl_functions.h"

#include <stdexcept>
#include <string>

namespace dockyard {

void ThrowMissingGlFunction(const char* name) {
  throw std::runtime_error(std::string("the GL context has no ") + name);
}

}  // namespace dockyard
