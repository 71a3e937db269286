#include <cstdint>
#include <stdexcept>
#include <string>

#include "render/gl_context.h"
#include "render/gl_library.h"

namespace dockyard {
namespace {

// The part of EGL 1.5 (Khronos registry) in use, so that its headers need not be installed.
using EglDisplay = void*;
using EglContext = void*;
using EglInt = std::int32_t;
constexpr EglInt kEglPlatformSurfacelessMesa = 0x31DD, kEglOpenGlApi = 0x30A2;
constexpr EglInt kEglContextMajorVersion = 0x3098, kEglContextMinorVersion = 0x30FB;
constexpr EglInt kEglContextProfileMask = 0x30FD, kEglCoreProfileBit = 1, kEglNone = 0x3038;

class Egl {
 public:
  Egl() {
    const GlLibrary library("libEGL.so.1");
    library.Load(get_proc_address, "eglGetProcAddress");
    library.Load(get_platform_display, "eglGetPlatformDisplay");
    library.Load(initialize, "eglInitialize");
    library.Load(bind_api, "eglBindAPI");
    library.Load(create_context, "eglCreateContext");
    library.Load(destroy_context, "eglDestroyContext");
    library.Load(make_current, "eglMakeCurrent");
    library.Load(get_error, "eglGetError");
  }

  GlProc (*get_proc_address)(const char*) = nullptr;
  EglDisplay (*get_platform_display)(unsigned, void*, const std::intptr_t*) = nullptr;
  unsigned (*initialize)(EglDisplay, EglInt*, EglInt*) = nullptr;
  unsigned (*bind_api)(unsigned) = nullptr;
  EglContext (*create_context)(EglDisplay, void*, EglContext, const EglInt*) = nullptr;
  unsigned (*destroy_context)(EglDisplay, EglContext) = nullptr;
  unsigned (*make_current)(EglDisplay, void*, void*, EglContext) = nullptr;
  EglInt (*get_error)() = nullptr;
};

class EglSurfacelessContext final : public GlContext {
 public:
  EglSurfacelessContext() {
    display_ = egl_.get_platform_display(kEglPlatformSurfacelessMesa, nullptr, nullptr);
    if (!display_) Fail("no surfaceless display");
    if (!egl_.initialize(display_, nullptr, nullptr)) Fail("the display does not start");
    if (!egl_.bind_api(kEglOpenGlApi)) Fail("no desktop GL");
    const EglInt attributes[] = {
        kEglContextMajorVersion, 3,       kEglContextMinorVersion, 3, kEglContextProfileMask,
        kEglCoreProfileBit,      kEglNone};
    context_ = egl_.create_context(display_, nullptr, nullptr, attributes);
    if (!context_) Fail("no GL 3.3 core context");
    try {
      MakeCurrent();
      functions_ =
          LoadGlFunctions([this](const char* name) { return egl_.get_proc_address(name); });
    } catch (...) {
      Release();
      throw;
    }
  }
  ~EglSurfacelessContext() override { Release(); }

  void MakeCurrent() override {
    if (!egl_.bind_api(kEglOpenGlApi)) Fail("no desktop GL");
    if (!egl_.make_current(display_, nullptr, nullptr, context_)) Fail("context not made current");
  }

 private:
  // The display is the process's, shared with other contexts, and is not terminated.
  void Release() {
    egl_.make_current(display_, nullptr, nullptr, nullptr);
    egl_.destroy_context(display_, context_);
  }

  [[noreturn]] void Fail(const std::string& what) {
    throw std::runtime_error("EGL: " + what + " (error " + std::to_string(egl_.get_error()) + ")");
  }

  Egl egl_;
  EglDisplay display_ = nullptr;
  EglContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> CreateEglSurfacelessContext() {
  return std::make_unique<EglSurfacelessContext>();
}

}  // namespace dockyard
