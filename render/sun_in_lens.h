// How much of the sun's disc a lens has in sight, by a small view towards the sun.
#pragma once

#include <memory>

#include "render/scene_painter.h"
#include "render/stray_light.h"

namespace dockyard {

/// Of the scene that the painter prepared last; the context is current. Things nearer than 2 cm
/// before the lens do not count, as in its image, and objects whose shadow alone is drawn do not.
/// A sun behind the lens's back or without light has the share 0.
class SunSight {
 public:
  SunInLens Of(ScenePainter& painter, const Scene& scene, const Pose3& X_WC);

 private:
  std::unique_ptr<GlViewTarget> target_;
  FlatView view_;
};

}  // namespace dockyard
