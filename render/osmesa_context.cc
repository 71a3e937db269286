#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

#include "render/gl_context.h"
#include "render/gl_library.h"

#ifdef __SANITIZE_ADDRESS__
// Mesa 22.3 keeps about 500 bytes of each off-screen context for good; and EGL's displays are the
// process's.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\nleak:libEGL\nleak:_dri.so\n";
}
#endif

namespace dockyard {
namespace {

struct OsMesa {
  OsMesa() {
    const GlLibrary library("libOSMesa.so.8");
    library.Load(create_context, "OSMesaCreateContextAttribs");
    library.Load(destroy_context, "OSMesaDestroyContext");
    library.Load(make_current, "OSMesaMakeCurrent");
    library.Load(get_proc_address, "OSMesaGetProcAddress");
  }

  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) get_proc_address = nullptr;
};

class OsMesaContext final : public GlContext {
 public:
  OsMesaContext() {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    context_ = mesa_.create_context(attributes, nullptr);
    if (!context_) throw std::runtime_error("OSMesa gives no GL 3.3 core context");
    try {
      MakeCurrent();
      functions_ =
          LoadGlFunctions([this](const char* name) { return mesa_.get_proc_address(name); });
    } catch (...) {
      mesa_.destroy_context(context_);
      throw;
    }
  }
  ~OsMesaContext() override {
    mesa_.make_current(nullptr, nullptr, 0, 0, 0);
    mesa_.destroy_context(context_);
  }

  void MakeCurrent() override {
    // The library wants a buffer of its own; nothing is ever drawn there.
    if (!mesa_.make_current(context_, unused_.data(), GL_UNSIGNED_BYTE, kSide, kSide)) {
      throw std::runtime_error("OSMesa cannot make its context current");
    }
  }

 private:
  static constexpr int kSide = 4;
  OsMesa mesa_;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4 * kSide * kSide> unused_{};
};

}  // namespace

std::unique_ptr<GlContext> CreateOsMesaContext() { return std::make_unique<OsMesaContext>(); }

}  // namespace dockyard
