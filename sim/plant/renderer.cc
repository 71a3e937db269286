#include "sim/plant/renderer.h"

#include <unistd.h>

#include <cstdlib>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "controller/base/check.h"
#include "models/read/config_error.h"
#include "models/read/guarded_work.h"

namespace dockyard {
namespace {

GlBackend ChosenGl() { return GlWord() == "egl" ? GlBackend::kEglSurfaceless : GlBackend::kOsMesa; }

// A run made ready and its first images took up to 1 s and 270 MiB, 2 s by softpipe; the machine
// may be busy.
constexpr WorkLimits kAskLimits{
    .cpu_s = 20, .wall_s = 60.0, .memory_bytes = std::size_t{2} << 30, .answer_bytes = 4096};

constexpr const char* kNames[] = {"gl_vendor", "gl_renderer", "gl_version"};

/// In the child: the values of kNames, a line each; or one line, the reason for none.
std::string AskContext() {
  try {
    const GlNames names = StereoRenderer(ChosenGl()).names();
    return names.vendor + "\n" + names.renderer + "\n" + names.version;
  } catch (const std::runtime_error& error) {
    return "none: " + std::string(error.what());
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

void DrawWithoutThreads() {
  ::setenv("LP_NUM_THREADS", "0", /*overwrite=*/0);                // of llvmpipe
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", /*overwrite=*/0);  // which another thread writes
}

std::string AskInChild(const std::function<std::string()>& draw) {
  try {
    const WorkResult result = RunGuarded(kAskLimits, [&] {
      ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // the child may write no file
      return draw();
    });
    return result.failure.empty() ? result.answer : "none: " + result.failure;
  } catch (const std::system_error& error) {
    return "none: " + std::string(error.what());
  }
}

std::vector<Fact> RendererFacts() {
  std::vector<Fact> facts{{"gl", GlWord()}};
  const std::string answer = AskInChild(AskContext);
  std::vector<std::string> values;
  std::istringstream lines(answer);
  for (std::string line; std::getline(lines, line);) values.push_back(line);
  if (values.size() != std::size(kNames)) values = {"none", answer, "none"};
  for (std::size_t i = 0; i < values.size(); ++i) facts.push_back({kNames[i], values[i]});
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
