#include "sim/run/renderer.h"

#include <unistd.h>

#include <cstdlib>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "controller/base/check.h"
#include "models/read/config_error.h"
#include "models/read/guarded_work.h"
#include "sim/base/hash.h"
#include "sim/run/test_image.h"

namespace dockyard {
namespace {

GlBackend ChosenGl() { return GlWord() == "egl" ? GlBackend::kEglSurfaceless : GlBackend::kOsMesa; }

// Context and image took 0.3 s and 90 MiB; the first shader may wait for a busy machine.
constexpr WorkLimits kAskLimits{
    .cpu_s = 20, .wall_s = 60.0, .memory_bytes = std::size_t{2} << 30, .answer_bytes = 4096};

constexpr const char* kNames[] = {"gl_vendor", "gl_renderer", "gl_version", "gl_image"};

/// In the child: the values of kNames, a line each; or one line, the reason for none.
std::string AskContext() {
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // the child may write no file
  try {
    StereoRenderer renderer(ChosenGl());
    const StereoImages images = TestImages(renderer);
    if (!ShowsTheTestScene(images.left)) return "the image drawn is wrong";
    const GlNames names = renderer.names();
    return names.vendor + "\n" + names.renderer + "\n" + names.version + "\n" +
           HexText(ImageFingerprint(images));
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
  std::vector<std::string> values;
  std::istringstream lines(result.answer);
  for (std::string line; std::getline(lines, line);) values.push_back(line);
  if (!result.failure.empty() || values.size() != std::size(kNames)) {
    const std::string why = result.failure.empty() ? result.answer : result.failure;
    values = {"none", "none", "none", "none: " + why};
  }
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
