// A point on a face, followed from one pair of the mast's pictures to the next.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "controller/rocky7/face_stereo.h"
#include "controller/stereo/face_patch.h"

namespace dockyard::rocky7 {

/// Where a look has the target; or why it has it not.
struct FaceSighting {
  bool found = false;
  bool ranged = true;  // else only its direction is seen, its range is the expected one
  Eigen::Vector3d p_E{0, 0, 0};
  double range_m = 0.0;                       // from the left camera
  std::optional<Eigen::Vector3d> normal_E{};  // outwards; none where too few points are seen
  double normal_sigma_rad = 0.0;
  Eigen::Matrix3d bend_E = Eigen::Matrix3d::Zero();  // as FacePlane has it
  double score = 0.0;
  std::string why{};  // in a few words; empty when found without a remark
};

/// Where odometry has the target: since the look that found it last the rover turned by turned_rad,
/// counter-clockwise, and drove way_m. Its drift aside on a cross slope may be off by drift_m, 1
/// sigma.
struct FaceExpected {
  Eigen::Vector3d p_E{0, 0, 0};
  double turned_rad = 0.0, way_m = 0.0, drift_m = 0.0;
};

/// Where the mast points, 1 sigma. Assumed, 0.2-0.5 deg.
inline constexpr double kPoints_rad = Radians(0.3);

class FaceTracker {
 public:
  virtual ~FaceTracker() = default;
  /// The first look: the user clicked on this pixel of the rectified left picture.
  virtual FaceSighting Begin(const FaceStereo& stereo, const FaceView& view,
                             const Eigen::Vector2d& pixel) = 0;
  /// A later one.
  virtual FaceSighting Follow(const FaceStereo& stereo, const FaceView& view,
                              const FaceExpected& target) = 0;
};

/// Ours: the appearance of the face about the target, with its range as a check.
class PatchTracker final : public FaceTracker {
 public:
  FaceSighting Begin(const FaceStereo& stereo, const FaceView& view,
                     const Eigen::Vector2d& pixel) override;
  FaceSighting Follow(const FaceStereo& stereo, const FaceView& view,
                      const FaceExpected& target) override;

 private:
  static FaceSighting Measure(const FaceStereo& stereo, const FaceView& view,
                              const Eigen::Vector2d& pixel);
  void Keep(const FaceView& view, const FaceSighting& seen);
  FaceSighting Search(const FaceStereo& stereo, const FaceView& view, const FaceExpected& target);

  FacePatchSettings settings_;
  FacePatch patch_;
  Pose3 X_EC_;                     // of the patch's picture, in the E of then
  Eigen::Vector3d p_ET_{0, 0, 0};  // the target in that
  double turned_rad_ = 0.0;        // of the rover, since then
  double range_m_ = 0.0;           // by the last look that found it
  int missed_ = 0;                 // image pairs in a row that did not
};

/// The paper's: the highest cell of a window (controller/tracking/local_maximum.h).
std::unique_ptr<FaceTracker> MakeTopTracker(const NesnasTracking& with);

}  // namespace dockyard::rocky7
