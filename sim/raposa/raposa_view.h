// From the truth to pictures: the only caller of render/.
#pragma once

#include <vector>

#include "render/colour_sensor.h"
#include "render/colour_table.h"
#include "render/scene.h"
#include "render/stereo_renderer.h"
#include "sim/base/random.h"
#include "sim/plant/light.h"
#include "sim/raposa/build_run.h"
#include "sim/raposa/world.h"
#include "sim/run/stage_shapes.h"

namespace dockyard::raposa {

/// Builds the scene that the camera sees. Meshes and spectra are converted once; poses come from
/// the truth.
class SceneBuilder {
 public:
  SceneBuilder(const BuiltRun& built, Lighting lighting, const Seed& run_seed);

  /// The scene borrows the grid's heights: draw it before the grid changes.
  Scene Make(const Truth& truth, const HeightGrid& ground, bool lamps_on) const;
  const ColourTable& colours() const { return colours_; }
  /// For spectators; bodies in the order of RaposaPlant::Look.
  StageShapes Shapes() const;

 private:
  std::vector<DrawnPart> Convert(const std::vector<Visual>& visuals);
  int GreyMaterial(double reflectance);
  int MaterialOf(const Spectrum& reflectance);

  SceneSpectra spectra_;
  std::vector<DrawnPart> body_, arm_, left_door_, right_door_, pyramid_;
  std::vector<StagePart> socket_, left_plate_, right_plate_;  // for spectators
  Lighting lighting_;
  LampsModel lamps_;
  Pose3 X_WG_;
  double cable_m_ = 0.0;
  int cable_material_ = 0;
  double grain_ = 0.0, mark_reach_m_ = 0.0;
  Eigen::Vector3d p_RC_, ground_rgb_{0.5, 0.5, 0.5};
  bool hide_pyramid_ = false;
  std::uint64_t texture_seed_ = 0;
  ColourTable colours_;
};

ColourView ViewOf(const BackCameraModel& camera);
/// The camera balanced for white under that light, or by itself.
ColourSensorOptions SensorOf(const BackCameraModel& camera, double balance_k,
                             bool auto_balance = false);
/// A filament's light below 4000 K, daylight above.
Spectrum LightOf(double temperature_k);

}  // namespace dockyard::raposa
