// A GL 3.3 core context without a window. Drawing goes into framebuffers of our own only, so that
// the back ends differ in nothing but their creation. One context per thread.
#pragma once

#include <memory>

#include "render/gl_functions.h"

namespace dockyard {

class GlContext {
 public:
  virtual ~GlContext() = default;
  /// Makes it current on the calling thread. Throws std::runtime_error when refused.
  virtual void MakeCurrent() = 0;
  /// The entry points of this context; valid while it lives and is current.
  const GlFunctions& functions() const { return functions_; }

 protected:
  GlFunctions functions_;
};

/// Mesa's off-screen library (removed from Mesa in 25.1). Throws std::runtime_error with the
/// reason.
std::unique_ptr<GlContext> CreateOsMesaContext();

/// EGL on Mesa's surfaceless platform. Either library is loaded at run time: a machine without the
/// one can still draw by the other. Throws std::runtime_error with the reason.
std::unique_ptr<GlContext> CreateEglSurfacelessContext();

}  // namespace dockyard
