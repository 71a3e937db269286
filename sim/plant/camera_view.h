// The images of one camera of a robot, grey or colour.
#pragma once

#include <functional>
#include <string>

#include "controller/io/sensors.h"
#include "render/colour_table.h"
#include "render/colour_view.h"
#include "render/kept_sensor.h"
#include "sim/plant/built_cameras.h"

namespace dockyard {

/// Where a camera is at the middle of an exposure, and how it moves; of a built camera on its link:
/// CameraOnLink.
struct CameraMotion {
  Pose3 X_WC;
  Eigen::Vector3d v_WC_W{0, 0, 0}, w_WC_W{0, 0, 0};  // of its centre [m/s]; [rad/s]
};
CameraMotion CameraOnLink(const Pose3& X_LC, const Pose3& X_WL, const Eigen::Vector3d& v_WL_W,
                          const Eigen::Vector3d& w_WL_W);

/// Takes the images of one camera in a run. It keeps what the camera keeps from image to image: the
/// number of its images, the exposure that the image before sets, and a colour camera's exposure
/// and white balance.
class SimulatedCamera {
 public:
  /// number: as in SensorFrame. The errors and the noise follow from the seed and the camera's
  /// name.
  SimulatedCamera(const CameraModel& model, const Seed& run_seed, int number);

  const CameraModel& model() const { return model_; }
  const Camera& built() const { return built_.camera; }
  const LensRipple& ripple() const { return built_.ripple; }
  const Pose3& X_LC() const { return built_.X_LC; }

  /// The scene `seconds` after the middle of the exposure: the world may be at rest for so long,
  /// but the robot's own parts move with the camera.
  using SceneAt = std::function<Scene(double seconds)>;
  struct Conditions {
    double nearest_m = 0.3;       // what the camera may have in view: decides how finely a moving
                                  // camera's exposure is divided
    double exposure_stops = 0.0;  // as Commands::exposure_stops; of grey cameras
    std::function<void(SensorOptions&)> faults{};  // of grey cameras; it changes their sensor
  };
  /// colours: of the scene's materials; a grey camera needs none. now: of the middle of the
  /// exposure of the middle row, which the image has as its own. A silent camera's image has no
  /// pixels.
  CameraImage Take(StereoRenderer& renderer, const SceneAt& scene, const ColourTable* colours,
                   const CameraMotion& motion, Tick now, const Conditions& conditions);

 private:
  GrayImage TakeGrey(StereoRenderer& renderer, const SceneAt& scene, const CameraMotion& motion,
                     const Conditions& conditions);
  RgbImage TakeColour(StereoRenderer& renderer, const Scene& scene, const ColourTable& colours,
                      const CameraMotion& motion, Tick now, const Conditions& conditions);
  double MotionIn_px(const CameraMotion& motion, double nearest_m, double seconds) const;

  CameraModel model_;
  Seed seed_;
  int number_ = 0, taken_ = 0;
  std::string stream_;
  BuiltOne built_;
  KeptSensor kept_;
  KeptExposure exposure_;
  ColourSensorState colour_state_;
  Tick last_ = 0;
};

}  // namespace dockyard
