// What one picture of the back camera says of the pyramid, without a setting for the light.
//
// Frame V: the camera in plan, x along its view, y left. Frame D: the guide's middle on the ground,
// x out along its axis.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/geometry/image.h"
#include "controller/geometry/pose.h"
#include "controller/raposa/nominal/nominal.h"
#include "controller/raposa/refuted_places.h"
#include "controller/raposa/square_sought.h"

namespace dockyard::raposa {

/// The guide, from its orange alone.
struct GuideSighting {
  Eigen::Vector2d centre_px{0.0, 0.0};
  double bearing_rad = 0.0;  // of its middle, to the left of the camera's axis
  double down_rad = 0.0;     // below the camera's axis
  double range_m = 0.0;      // from the camera, in plan
  double bearing_sigma_rad = 0.0, range_sigma_m = 0.0;
  bool clipped = false;  // the view's edge cuts it: it may be nearer, and farther aside
  // At which the square would be in view, and no blue is there.
  Angles without_square;
  // The side of the axis on which the camera probably is, for a picture without a pose: left of it,
  // seen from the guide, 1; right -1; not known 0.
  double likely_side = 0.0;
};

/// A pose of the pyramid that explains the picture.
struct PyramidFit {
  Pose2 X_VD;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of X_VD's x, y [m], heading [rad]
  double misfit = 0.0;  // mean square of the residuals by their sigmas; about 1 for a true one
  // As the fit has them: of the guide's middle below the camera, of the camera, down and clockwise.
  double down_m = 0.0, pitch_rad = 0.0, roll_rad = 0.0;
};

struct PyramidSighting {
  std::optional<GuideSighting> guide;
  /// With guide and blue marks in view: the pose, or both where the picture allows two. The better
  /// one first. Empty if the blue marks are not seen, or fit no pose.
  std::vector<PyramidFit> fits;
  /// Things refuted before that this image shows again: their index, and where.
  struct Known {
    std::size_t thing = 0;
    double bearing_rad = 0.0;
  };
  std::vector<Known> known;
};

/// What is believed of the pyramid before the picture.
struct PyramidPrior {
  Pose2 X_VD;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

class PyramidFinder {
 public:
  explicit PyramidFinder(const Nominal& nominal);

  /// @param pitch_rad  of the camera, down positive, as the arm's angle has it; known to 2 deg
  /// @param prior      marks that it rules out are other things of like colours
  /// @param refuted    things that are not searched
  PyramidSighting Find(const RgbImage& image, double pitch_rad,
                       const std::optional<PyramidPrior>& prior = std::nullopt,
                       const std::vector<RefutedThing>& refuted = {}) const;

 private:
  Nominal nominal_;
};

}  // namespace dockyard::raposa
