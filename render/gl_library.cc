#include "render/gl_library.h"

#include <dlfcn.h>

#include <stdexcept>

namespace dockyard {

GlLibrary::GlLibrary(const char* file) : file_(file) {
  library_ = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (!library_) throw std::runtime_error("no GL to draw with: " + std::string(dlerror()));
}

void* GlLibrary::Find(const char* name) const {
  void* found = dlsym(library_, name);
  if (!found) throw std::runtime_error(file_ + " has no " + name);
  return found;
}

}  // namespace dockyard
