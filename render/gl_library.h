// A library of GL that is loaded when something is drawn: its compiler takes 20 ms to load, and
// most commands draw nothing.
#pragma once

#include <string>

namespace dockyard {

class GlLibrary {
 public:
  /// Throws std::runtime_error with the reason when there is none. The library stays loaded: Mesa
  /// keeps state of each thread in it.
  explicit GlLibrary(const char* file);

  /// Throws std::runtime_error when the library has no such function.
  template <class Function>
  void Load(Function& function, const char* name) const {
    function = reinterpret_cast<Function>(Find(name));
  }

 private:
  void* Find(const char* name) const;

  std::string file_;
  void* library_ = nullptr;
};

}  // namespace dockyard
