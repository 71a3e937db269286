// The renderer of a run's images: by which GL it draws, and one for all runs of a process.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/stereo_renderer.h"
#include "sim/base/environment.h"

namespace dockyard {

/// The word in the environment's DOCKYARD_GL: "osmesa", also when there is none, or "egl". Throws
/// ConfigError.
std::string GlWord();

/// A renderer that draws by the GL of GlWord(). Throws ConfigError, and std::runtime_error with the
/// reason when no context can be had.
std::unique_ptr<StereoRenderer> MakeRenderer();

/// Contexts made later in this process draw without threads of Mesa's own, unless the environment
/// asks for them: for one of several processes that draw and would wait for each other's threads.
/// The images are the same.
void DrawWithoutThreads();

/// Who draws, and how, in this order: gl (GlWord()), gl_vendor, gl_renderer and gl_version. If
/// there is no context, the value of gl_renderer is "none: " and the reason, and vendor and version
/// are "none". Throws ConfigError.
std::vector<Fact> RendererFacts();

/// What `draw` returns, in a process of its own, as a process that has drawn cannot have children
/// that draw; "none: " and the reason where that process fails.
std::string AskInChild(const std::function<std::string()>& draw);

/// One renderer for all runs of a process. It is made at the first use: a process that takes no
/// images needs none. The images do not depend on those drawn before.
class KeptRenderer {
 public:
  KeptRenderer() = default;
  ~KeptRenderer();
  KeptRenderer(const KeptRenderer&) = delete;
  KeptRenderer& operator=(const KeptRenderer&) = delete;

  /// Throws as MakeRenderer. In a child of a process that has used it this is a fault of ours: Mesa
  /// would wait for ever for the threads of the parent.
  StereoRenderer& Get();

 private:
  int process_ = 0;  // that made it
  std::unique_ptr<StereoRenderer> renderer_;
};

}  // namespace dockyard
