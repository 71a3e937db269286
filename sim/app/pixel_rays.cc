#include "sim/app/pixel_rays.h"

#include "controller/base/number_text.h"
#include "models/read/config_error.h"

namespace dockyard {

void RequirePixelRays(const std::vector<PointFrame>& frames, const StereoRig& rig,
                      const std::string& file) {
  for (const PointFrame& frame : frames) {
    for (std::size_t i = 0; i < frame.points.size(); ++i) {
      const PointPixel& point = frame.points[i];
      const Camera& camera = point.view == 0 ? rig.left : rig.right;
      // Pixels off the image are another fault.
      if (!camera.Sees(point.pixel) || camera.HasRay(point.pixel)) continue;
      throw ConfigError(file + ": row " + std::to_string(frame.rows[i]) +
                        ": expected a pixel to which the " + (point.view == 0 ? "left" : "right") +
                        " camera's lens gives a ray, found '" + NumberText(point.pixel.x()) + " " +
                        NumberText(point.pixel.y()) +
                        "', where its polynomial has turned back: leave this point out");
    }
  }
}

}  // namespace dockyard
