// Pictures of the pyramid from anywhere, with what is true of them.
#pragma once

#include <optional>
#include <string>

#include "controller/geometry/image.h"
#include "controller/raposa/nominal/nominal.h"
#include "sim/plant/renderer.h"

namespace dockyard::raposa {

struct ImageSetup {
  double r_m = 1.0, alpha_rad = 0.0;  // of the camera about the guide
  double beside_rad = 0.0;            // the camera looks so far to the left of the guide
  double light_k = 5000.0, balance_k = 5000.0;
  std::string ground = "hard_floor";  // a file of models/raposa/grounds
  std::string light = "even";         // even, speckled or hard_shadow
  double light_level = 1.0;           // of all light but the lamps'
  bool lamps = false;
  double arm_rad = 0.0;  // pressed down by this, so that the body leans back
  double undulation_rms_m = 0.0;
  int things = 0;  // of sim/raposa/clutter.h, about the pyramid
  std::uint64_t seed = 1;
};

struct TakenImage {
  RgbImage image;
  Nominal nominal;
  Pose2 X_VD;  // V: the camera in plan, x along its view
  std::optional<Eigen::Vector2d> guide_px;
  double pitch_rad = 0.0;  // of the camera, down
  bool in_view = false;    // the guide's middle, inside the hole's rim and its shade
};

/// The robot stands still; r_m is from where it stood before it pressed its arm.
TakenImage ExposeColourViewOf(const ImageSetup& setup,
                              const std::shared_ptr<KeptRenderer>& renderer);

/// What stands on the ground in the pyramid's place.
enum class Instead {
  kThings,    // 40 pieces of sim/raposa/clutter.h: bricks, cones, denim, some beside each other
  kForgeries  // of the marks' own paints and sizes, each orange one close to a blue one
};

/// The same view without the pyramid. The camera's Nominal and pitch are as in the other.
TakenImage TakeClutterOf(const ImageSetup& setup, const std::shared_ptr<KeptRenderer>& renderer,
                         Instead instead);

}  // namespace dockyard::raposa
