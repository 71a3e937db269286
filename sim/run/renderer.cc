#include "sim/run/renderer.h"

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "controller/base/check.h"
#include "models/read/config_error.h"
#include "models/read/guarded_work.h"

namespace dockyard {
namespace {

GlBackend ChosenGl() { return GlWord() == "egl" ? GlBackend::kEglSurfaceless : GlBackend::kOsMesa; }

// A context took 0.1 s and 60 MiB; compiling its first shader may wait for a busy machine.
constexpr WorkLimits kAskLimits{
    .cpu_s = 20, .wall_s = 60.0, .memory_bytes = std::size_t{2} << 30, .answer_bytes = 4096};

/// In the child: vendor, renderer and version, a line each; or nothing but the reason.
std::string AskContext() {
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // the child may write no file
  try {
    const GlNames names = StereoRenderer(ChosenGl()).names();
    return names.vendor + "\n" + names.renderer + "\n" + names.version;
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace

std::string GlWord() {
  const char* word = std::getenv("DOCKYARD_GL");
  if (word == nullptr || *word == '\0') return "osmesa";
  if (std::string(word) != "osmesa" && std::string(word) != "egl") {
    throw ConfigError("the environment's DOCKYARD_GL: expected osmesa or egl, found '" +
                      std::string(word) + "'");
  }
  return word;
}

std::unique_ptr<StereoRenderer> MakeRenderer() {
  return std::make_unique<StereoRenderer>(ChosenGl());
}

std::vector<Fact> RendererFacts() {
  std::vector<Fact> facts{{"gl", GlWord()}};
  WorkResult result;
  try {
    result = RunGuarded(kAskLimits, AskContext);
  } catch (const std::system_error& error) {
    result.failure = error.what();
  }
  const std::size_t first = result.answer.find('\n'), last = result.answer.rfind('\n');
  if (!result.failure.empty() || first == last) {
    const std::string why = result.failure.empty() ? result.answer : result.failure;
    facts.insert(facts.end(),
                 {{"gl_vendor", "none"}, {"gl_renderer", "none"}, {"gl_version", why}});
    return facts;
  }
  facts.push_back({"gl_vendor", result.answer.substr(0, first)});
  facts.push_back({"gl_renderer", result.answer.substr(first + 1, last - first - 1)});
  facts.push_back({"gl_version", result.answer.substr(last + 1)});
  return facts;
}

KeptRenderer::~KeptRenderer() {
  // The parent's context is not this process's to end.
  if (process_ != ::getpid()) static_cast<void>(renderer_.release());
}

StereoRenderer& KeptRenderer::Get() {
  if (renderer_ == nullptr) {
    renderer_ = MakeRenderer();
    process_ = ::getpid();
  }
  DOCKYARD_CHECK(process_ == ::getpid());
  return *renderer_;
}

}  // namespace dockyard
